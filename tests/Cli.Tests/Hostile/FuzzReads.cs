using Harvester.Cli.Commands;
using Harvester.Datasets.Faces;
using Harvester.Datasets.Files;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Sharding;
using Harvester.Datasets.Statistics;
using Harvester.Datasets.Validation;
using Harvester.Exports.Assembly;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Reports.Viewing;
using Harvester.Sessions.Events;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Reads files of the corpus in the test's process, from its folder, without a command line.</summary>
internal static class FuzzReads
{
    public static void ValidatePictures(string folder) => SessionValidator.Validate(new SessionReader(In(folder, "session")));

    /// <summary>Without decoding pictures, which are sound and would take most of the time.</summary>
    public static void ValidateSession(string folder) => SessionValidator.Validate(new SessionReader(In(folder, "session")), isQuick: true);

    public static void ReadLabels(string folder)
    {
        ValidateSession(folder);
        SessionStatistics.Of(new SessionReader(In(folder, "session")).ReadLabels());
        ViewFrames(folder);
    }

    public static void ReadEvents(string folder)
    {
        var session = new SessionReader(In(folder, "eventful"));
        SessionValidator.Validate(session, isQuick: true);
        foreach (DrivingEvent happened in session.ReadEvents())
        {
            EventCheck.FirstProblem(happened);
        }
    }

    public static void ReadRoadsOfSession(string folder)
    {
        RoadImporter.Import(In(folder, "session/scenes/roads.csv"));
        ViewFrames(folder);
    }

    public static void ReadPeople(string folder)
    {
        var session = new SessionReader(In(folder, "people"));
        SessionStatistics.Of(session.ReadLabels());
    }

    public static FaceTable ReadFaces(string path) => FaceFile.ReadValid(path, static _ => { });

    public static void MergeShards(string folder)
    {
        string merged = In(folder, "merged");
        if (Directory.Exists(merged))
        {
            Directory.Delete(merged, recursive: true);
        }

        DatasetMerger.Merge([In(folder, "shard"), In(folder, "shard2")], merged, new MergeOptions(ImageTransfer.Link));
    }

    public static void ReadPoints(string folder)
    {
        var intrinsics = new CameraIntrinsics(50, new ImageSize(80, 60), 4.0 / 3, 0.1, Lens.Ideal);
        var camera = new Camera(new Pose(Vector3D.Zero, Axes.FromHeading(0)), intrinsics);
        ProjectCommand.Project(camera, InputFile.OpenText(In(folder, "points.csv")), "points.csv", TextWriter.Null);
    }

    public static void ReadVehicles(string folder)
    {
        RoadNetwork network = RoadImporter.Import(In(folder, "session/scenes/roads.csv")).Network;
        var observer = new LaneObserver(new RoadCurves(network), new LaneModel(network), LookAhead.Thesis);
        TrafficVehicle[] vehicles = LanesCommand.ReadVehicles(new FileInfo(In(folder, "vehicles.csv")));
        LanesCommand.TextOf(observer.Observe(Vector3D.Zero, headingDegrees: 0, speed: 10, length: 4.5, vehicles, previous: null));
    }

    /// <summary>As the viewer shows them, with the lanes around the ego.</summary>
    private static void ViewFrames(string folder)
    {
        using var view = new SessionView(new SessionReader(In(folder, "session")));
        for (int frame = 0; frame < view.Frames; frame++)
        {
            view.Frame(frame);
        }
    }

    public static string In(string folder, string name) => Path.Combine(folder, name);
}
