using System.Text.Json;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>
/// The classes and instances of the points of samples, as nuScenes-lidarseg and Panoptic nuScenes have them: a byte for each point, and the
/// number 1000 · category + instance.
/// </summary>
internal static class NuScenesSegments
{
    /// <summary>Name of the table of classes, and of the folder of its files.</summary>
    public const string Classes = "lidarseg";

    /// <summary>Name of the table of instances, and of the folder of its files.</summary>
    public const string Instances = "panoptic";

    /// <summary>Name of the array in a file of instances.</summary>
    public const string ArrayName = "data";

    /// <summary>By what a category is multiplied.</summary>
    public const int CategoryFactor = 1000;

    /// <summary>Name of the part that a frame with such files writes, from which the tables know of them.</summary>
    public const string Part = "segments";

    private const string PointsExtension = ".pcd.bin";

    /// <summary>Path of the classes of the points of a file.</summary>
    public static string ClassesOf(string points) => PathOf(Classes, points, ".bin");

    /// <summary>Path of the instances of the points of a file.</summary>
    public static string InstancesOf(string points) => PathOf(Instances, points, ".npz");

    /// <summary>Writes the files of the points of a sample.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="file">Path of the points in the dataset.</param>
    /// <param name="points">The points.</param>
    /// <param name="output">Takes the files.</param>
    public static void Write(ExportFrame frame, string file, LidarPoint[] points, FrameOutput output)
    {
        Riders riders = Riders.At(frame);
        Dictionary<int, string?> named = NamesIn(frame);
        var owners = new int[points.Length];
        var categories = new byte[points.Length];
        for (int i = 0; i < points.Length; i++)
        {
            // The points of a rider are those of the vehicle, as in nuScenes.
            (int Id, ObjectClass Class)? ridden = riders.VehicleOf(points[i].ObjectId);
            owners[i] = ridden?.Id ?? points[i].ObjectId;
            string category =
                named.GetValueOrDefault(owners[i])
                ?? (ridden is { } vehicle ? NuScenesClasses.CategoryOf(vehicle.Class, "") : null)
                ?? CategoryOf(points[i].Class);
            categories[i] = (byte)NuScenesClasses.IndexOf(category);
        }

        output.File(ClassesOf(file), stream => stream.Write(categories));
        ushort[] panoptic = PanopticOf(categories, owners);
        output.File(InstancesOf(file), stream => NpzFile.Write(stream, ArrayName, panoptic));
        output.Part(Part, "");
    }

    /// <summary>The tables, of a dataset that has such files.</summary>
    /// <param name="part">Name of the parts of the frames.</param>
    public static IEnumerable<AggregateFile> Tables(string part) =>
        [TableOf(part, Classes, ClassesOf), TableOf(part, Instances, InstancesOf)];

    private static AggregateFile TableOf(string part, string name, Func<string, string> pathOf) =>
        new(
            $"{NuScenesWriter.Version}/{name}.json",
            [
                AggregateSection.Summary(
                    part,
                    (writer, parts) =>
                        NuScenesTables.WriteList(writer, NuScenesScene.All(parts).SelectMany(scene => Records(scene, pathOf)))
                ),
            ]
        );

    /// <summary>The categories of the objects of a moment by their ids: of the scene or, without one, of the image.</summary>
    private static Dictionary<int, string?> NamesIn(ExportFrame frame)
    {
        var named = new Dictionary<int, string?>();
        foreach (EntityState entity in frame.Scene?.Snapshot.Entities ?? [])
        {
            if (frame.Scene!.Ids.TryGetValue(entity.Handle, out int id))
            {
                named[id] = NuScenesClasses.CategoryOf(entity.Class, entity.Model);
            }
        }

        foreach (ObjectLabel label in frame.Label.Objects.Where(static label => label.Parent is null))
        {
            named[label.Id] = NuScenesClasses.CategoryOf(label);
        }

        return named;
    }

    /// <summary>Whether a category is of things, which have instances.</summary>
    private static bool IsThing(byte category) => category is > 0 and < NuScenesClasses.FirstStuff;

    /// <summary>
    /// The numbers of points. The instance of an object is 1 + (id - 1) mod 999, so that it is the same in all samples; should two objects
    /// of a sweep share it, the one of the greater id takes the next that is free.
    /// </summary>
    private static ushort[] PanopticOf(byte[] categories, int[] owners)
    {
        var instances = new Dictionary<(byte Category, int Id), int>();
        var taken = new HashSet<(byte Category, int Instance)>();
        foreach (
            (byte Category, int Id) thing in categories
                .Zip(owners)
                .Where(static each => IsThing(each.First))
                .Distinct()
                .OrderBy(static each => each)
        )
        {
            int instance = thing.Id <= 0 ? 0 : 1 + ((thing.Id - 1) % (CategoryFactor - 1));
            for (int tried = 1; instance > 0 && !taken.Add((thing.Category, instance)) && tried < CategoryFactor - 1; tried++)
            {
                instance = 1 + (instance % (CategoryFactor - 1));
            }

            instances[thing] = instance;
        }

        return
        [
            .. categories.Zip(
                owners,
                (category, owner) => (ushort)((CategoryFactor * category) + (IsThing(category) ? instances[(category, owner)] : 0))
            ),
        ];
    }

    private static string CategoryOf(SemanticClass kind) =>
        kind switch
        {
            SemanticClass.Road or SemanticClass.LaneMarking => "flat.driveable_surface",
            SemanticClass.Pavement => "flat.sidewalk",
            SemanticClass.Terrain => "flat.terrain",
            SemanticClass.Water => "flat.other",
            SemanticClass.Building or SemanticClass.Pole or SemanticClass.Fence or SemanticClass.Sign or SemanticClass.TrafficLight =>
                "static.manmade",
            SemanticClass.Vegetation => "static.vegetation",
            SemanticClass.Car => "vehicle.car",
            SemanticClass.Truck => "vehicle.truck",
            SemanticClass.Bus => "vehicle.bus.rigid",
            SemanticClass.Motorcycle => "vehicle.motorcycle",
            SemanticClass.Bicycle => "vehicle.bicycle",
            SemanticClass.Trailer => "vehicle.trailer",
            SemanticClass.Pedestrian => "human.pedestrian.adult",
            SemanticClass.Other => "static.other",
            _ => NuScenesClasses.Noise,
        };

    private static IEnumerable<Action<Utf8JsonWriter>> Records(NuScenesScene scene, Func<string, string> pathOf) =>
        from frame in scene.Frames
        where frame.IsKey
        from sensor in frame.Sensors
        where sensor.Modality == NuScenesSensor.Lidar
        select (Action<Utf8JsonWriter>)(
            json =>
            {
                string token = scene.DataTokenOf(sensor.Channel, frame.Moment);
                json.WriteStartObject();
                json.WriteString("token", token);
                json.WriteString("sample_data_token", token);
                json.WriteString("filename", pathOf(sensor.File));
                json.WriteEndObject();
            }
        );

    private static string PathOf(string folder, string points, string extension)
    {
        string name = Path.GetFileName(points);
        string bare = name.EndsWith(PointsExtension, StringComparison.Ordinal) ? name[..^PointsExtension.Length] : name;
        return $"{folder}/{NuScenesWriter.Version}/{bare}_{folder}{extension}";
    }
}
