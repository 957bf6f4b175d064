using Harvester.Cli.Boxes;
using Harvester.Cli.Commands;
using Harvester.Cli.Faces;
using Harvester.Cli.Relabelling;
using Harvester.Datasets.Diagnosis;
using Harvester.Datasets.Exports.Assembly;
using Harvester.Datasets.Exports.Validation;
using Harvester.Datasets.Files;
using Harvester.Datasets.Images;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Statistics;
using Harvester.Datasets.Validation;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>What reads a kind of input file in the test's process, without a command line where there is a type for it.</summary>
/// <param name="Name">The kind, as in <see cref="FuzzKind"/>.</param>
/// <param name="File">The file to damage, in the folder of the corpus.</param>
/// <param name="Read">Reads it, from the folder of the corpus.</param>
internal sealed record FuzzReader(string Name, string File, Action<string> Read)
{
    /// <summary>All kinds.</summary>
    public static IReadOnlyList<FuzzReader> All { get; } =
    [
        new("session", "session/session.json", ValidateSession),
        new("labels", "session/labels.jsonl", folder =>
        {
            ValidateSession(folder);
            SessionStatistics.Of(new SessionReader(In(folder, "session")).ReadLabels());
        }),
        new("scene", "session/scenes/00000000.json", ValidateSession),
        new("roads", "session/scenes/roads.csv", folder => RoadImporter.Import(In(folder, "session/scenes/roads.csv"))),
        new("faces", "session/scenes/spaces.csv", folder => FaceFile.ReadValid(In(folder, "session/scenes/spaces.csv"), static _ => { })),
        new("png", "session/frames/00000000.png", folder => PictureReader.Read(In(folder, "session/frames/00000000.png"))),
        new("mask", "session/masks/00000000.png", ValidateSession),
        new("map", "maps/0.png", folder => PngDecoder.ReadInstanceMap(In(folder, "maps/0.png"))),
        new("jpg", "jpg/frames/00000000.jpg", folder => PictureReader.Read(In(folder, "jpg/frames/00000000.jpg"))),
        new("bmp", "bmp/frames/00000000.bmp", folder => PictureReader.Read(In(folder, "bmp/frames/00000000.bmp"))),
        Dataset("manifest", "csv", "export.json"),
        Dataset("csv-frames", "csv", "frames.csv"),
        Dataset("csv-objects", "csv", "objects.csv"),
        Dataset("coco", "coco", "annotations/instances_train.json"),
        Dataset("panoptic", "coco-panoptic", "annotations/panoptic_train.json"),
        Dataset("kitti", "kitti", "training/label_2/000000.txt"),
        Dataset("voc", "voc", "Annotations/00000000.xml"),
        Dataset("yolo", "yolo", "labels/train/00000000.txt"),
        Dataset("webdataset", "webdataset", "train-000000.tar"),
        new("plan", "shard/.export/plan.json", Merge),
        new("journal", "shard/.export/journal-1-of-2.jsonl", Merge),
        new("points", "points.csv", folder =>
        {
            var intrinsics = new CameraIntrinsics(50, new ImageSize(80, 60), 4.0 / 3, 0.1, Lens.Ideal);
            var camera = new Camera(new Pose(Vector3D.Zero, Axes.FromHeading(0)), intrinsics);
            ProjectCommand.Project(camera, InputFile.OpenText(In(folder, "points.csv")), "points.csv", TextWriter.Null);
        }),
        new("vehicles", "vehicles.csv", folder =>
        {
            RoadNetwork network = RoadImporter.Import(In(folder, "session/scenes/roads.csv")).Network;
            var observer = new LaneObserver(new RoadCurves(network), new LaneModel(network), LookAhead.Thesis);
            TrafficVehicle[] vehicles = LanesCommand.ReadVehicles(new FileInfo(In(folder, "vehicles.csv")));
            LanesCommand.TextOf(observer.Observe(Vector3D.Zero, headingDegrees: 0, speed: 10, length: 4.5, vehicles, previous: null));
        }),
        new("lens", "lens.txt", folder => LensFile.Read(In(folder, "lens.txt"))),
        new("boxes", "boxes.json", folder => BoxSceneReader.Read(new FileInfo(In(folder, "boxes.json")))),
        new("log", "GtaDataHarvester.log", folder => Doctor.Examine(In(folder, "GtaDataHarvester.log"))),
        new("photos", "survey/photos.csv", folder =>
            new FaceGallery(FaceFile.ReadValid(In(folder, "survey/spaces.csv"), static _ => { }), In(folder, "survey")).Write(Stream.Null)),
    ];

    /// <summary>What is against the promise in reading; null for nothing.</summary>
    public string? FaultOf(string folder)
    {
        try
        {
            Read(folder);
            return null;
        }
        catch (Exception e) when (e is DatasetFormatException or IOException or UnauthorizedAccessException)
        {
            return e.Message.Length > 0 ? null : $"{e.GetType().Name} without a message";
        }
        catch (Exception e)
        {
            return $"{e.GetType().Name}: {e.Message} {e.StackTrace?.Split('\n')[0].Trim()}";
        }
    }

    private static FuzzReader Dataset(string name, string dataset, string file) =>
        new(name, $"{dataset}/{file}", folder => DatasetValidator.Validate(In(folder, dataset)));

    private static void ValidateSession(string folder) => SessionValidator.Validate(new SessionReader(In(folder, "session")));

    private static void Merge(string folder)
    {
        string merged = In(folder, "merged");
        if (Directory.Exists(merged))
        {
            Directory.Delete(merged, recursive: true);
        }

        DatasetMerger.Merge([In(folder, "shard"), In(folder, "shard2")], merged, ImageTransfer.Link);
    }

    private static string In(string folder, string name) => Path.Combine(folder, name);
}
