using Harvester.Datasets.Statistics;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>Maps labels to KITTI's types and levels; docs/exports/kitti.md has the table.</summary>
internal static class KittiClasses
{
    /// <summary>Objects with at most this occluded fraction are fully visible.</summary>
    private const double MaxHiddenOfVisible = 0.1;

    /// <summary>Objects with at most this occluded fraction are partly occluded, others largely.</summary>
    private const double MaxHiddenOfPartly = 0.5;

    private const int UnknownOcclusion = 3;

    /// <summary>The types of objects.</summary>
    public static IReadOnlyCollection<string> Types { get; } =
    ["Car", "Van", "Truck", "Pedestrian", "Person_sitting", "Cyclist", "Tram", "Misc"];

    /// <summary>The type of ignore regions.</summary>
    public const string DontCare = "DontCare";

    /// <summary>Whether KITTI labels objects of a class. Riders belong to their vehicles.</summary>
    public static bool Has(ObjectClass kind) => KittiScope.Has(kind);

    /// <summary>Whether KITTI ignores regions of a class.</summary>
    public static bool Ignores(ObjectClass kind) => Has(kind) || kind == ObjectClass.Rider;

    /// <summary>The type of an object.</summary>
    /// <param name="label">The object, of a class that KITTI labels.</param>
    /// <param name="names">Types of classes that do not have the default.</param>
    public static string TypeOf(ObjectLabel label, IReadOnlyDictionary<ObjectClass, string> names) =>
        names.TryGetValue(label.Class, out string? name)
            ? name
            : label.Class switch
            {
                ObjectClass.Car => KittiVans.Has(label.Model) ? "Van" : "Car",
                ObjectClass.Truck => "Truck",
                ObjectClass.Pedestrian => "Pedestrian",
                ObjectClass.Bicycle when label.HasRider == true => "Cyclist",
                _ => "Misc",
            };

    /// <summary>0 fully visible, 1 partly, 2 largely occluded, 3 unknown.</summary>
    public static int OcclusionOf(ObjectLabel label) => label.OccludedFraction is { } hidden ? LevelOf(hidden) : UnknownOcclusion;

    /// <summary>KITTI tracking's truncation level: 0 none, 1 partly, 2 largely.</summary>
    public static int LevelOf(double fraction) =>
        fraction <= MaxHiddenOfVisible ? 0
        : fraction <= MaxHiddenOfPartly ? 1
        : 2;
}
