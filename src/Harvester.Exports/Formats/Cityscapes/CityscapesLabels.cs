using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Exports.Formats.Cityscapes;

/// <summary>
/// The exported rows of the benchmark's label table, and the instance ids: label id · 1000 + number, for labels with instances.
/// </summary>
internal static class CityscapesLabels
{
    public const int InstancesPerLabel = 1000;

    private const ushort NotTrained = 255;

    private static readonly CityscapesLabel[] Labels =
    [
        new("unlabeled", 0, NotTrained, false),
        new("static", 4, NotTrained, false),
        new("dynamic", 5, NotTrained, false),
        new("road", 7, 0, false),
        new("sidewalk", 8, 1, false),
        new("building", 11, 2, false),
        new("fence", 13, 4, false),
        new("pole", 17, 5, false),
        new("traffic light", 19, 6, false),
        new("traffic sign", 20, 7, false),
        new("vegetation", 21, 8, false),
        new("terrain", 22, 9, false),
        new("sky", 23, 10, false),
        new("person", 24, 11, true),
        new("rider", 25, 12, true),
        new("car", 26, 13, true),
        new("truck", 27, 14, true),
        new("bus", 28, 15, true),
        new("caravan", 29, NotTrained, true),
        new("trailer", 30, NotTrained, true),
        new("train", 31, 16, true),
        new("motorcycle", 32, 17, true),
        new("bicycle", 33, 18, true),
    ];

    /// <summary>All pixels that show no object.</summary>
    public static CityscapesLabel Unlabeled { get; } = Named("unlabeled");

    /// <summary>Posts of signs and traffic lights.</summary>
    public static CityscapesLabel Pole { get; } = Named("pole");

    /// <summary>The names of all labels.</summary>
    public static IReadOnlyCollection<string> Names { get; } = [.. Labels.Select(label => label.Name)];

    /// <summary>Label names that classes of objects can be given.</summary>
    public static IReadOnlyCollection<string> ObjectNames { get; } =
    [.. Names.Except(["road", "sidewalk", "building", "fence", "vegetation", "terrain", "sky"])];

    /// <summary>The label of a class.</summary>
    /// <param name="kind">The class.</param>
    /// <param name="names">Label names of classes that do not have the default.</param>
    public static CityscapesLabel Of(ObjectClass kind, IReadOnlyDictionary<ObjectClass, string> names) =>
        Named(
            names.TryGetValue(kind, out string? name)
                ? name
                : kind switch
                {
                    ObjectClass.Car => "car",
                    ObjectClass.Truck => "truck",
                    ObjectClass.Bus => "bus",
                    ObjectClass.Trailer => "trailer",
                    ObjectClass.Motorcycle => "motorcycle",
                    ObjectClass.Bicycle => "bicycle",
                    ObjectClass.Pedestrian => "person",
                    ObjectClass.Rider => "rider",
                    ObjectClass.TrafficLight => "traffic light",
                    ObjectClass.Sign => "traffic sign",
                    ObjectClass.Other => "dynamic",
                    _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "The class has no label in Cityscapes."),
                }
        );

    /// <summary>The label of a value in class maps; unlabeled for water, for objects, and for what is unknown.</summary>
    public static CityscapesLabel OfSurface(SemanticClass kind) =>
        kind switch
        {
            SemanticClass.Road or SemanticClass.LaneMarking => Named("road"),
            SemanticClass.Pavement => Named("sidewalk"),
            SemanticClass.Building => Named("building"),
            SemanticClass.Fence => Named("fence"),
            SemanticClass.Pole => Pole,
            SemanticClass.Vegetation => Named("vegetation"),
            SemanticClass.Terrain => Named("terrain"),
            SemanticClass.Sky => Named("sky"),
            _ => Unlabeled,
        };

    /// <summary>
    /// The label of an instance id, which is the label id itself for labels without instances; null for an unknown id.
    /// </summary>
    public static CityscapesLabel? OfInstance(ushort instance) =>
        instance >= InstancesPerLabel
            ? Labels.FirstOrDefault(label => label.HasInstances && label.Id == instance / InstancesPerLabel)
            : Labels.FirstOrDefault(label => !label.HasInstances && label.Id == instance);

    private static CityscapesLabel Named(string name) => Labels.First(label => label.Name == name);
}
