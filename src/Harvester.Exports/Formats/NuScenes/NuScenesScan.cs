using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Files;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The points of all LiDARs at one moment.</summary>
internal sealed class NuScenesScan
{
    private readonly List<Vector3D> _points = [];
    private readonly Dictionary<int, int> _hits = [];

    private NuScenesScan(string file) => File = file;

    /// <summary>The file of the first LiDAR, by which the moment is known.</summary>
    public string File { get; }

    /// <summary>The name of the file that identifies the scan of a frame's moment; null without a LiDAR.</summary>
    public static string? NameOf(ExportFrame frame) =>
        frame.Rig is { Lidars.Count: > 0 } rig ? frame.Session.PathOf(SweepOf(frame, rig, rig.Lidars[0])) : null;

    /// <summary>Reads the points of a frame's moment.</summary>
    /// <param name="frame">A frame of a rig with LiDARs.</param>
    /// <param name="ego">The fields translation and rotation of ego_pose, in the world, as JSON.</param>
    public static NuScenesScan Read(ExportFrame frame, string ego)
    {
        var scan = new NuScenesScan(NameOf(frame)!);
        Riders riders = Riders.At(frame);
        NuScenesMotion toWorld = MotionOf(ego);
        foreach (RigLidar lidar in frame.Rig!.Lidars)
        {
            string file = SweepOf(frame, frame.Rig, lidar);
            if (frame.HasFile(file))
            {
                NuScenesMotion toEgo = MotionOf(NuScenesSensor.Of(lidar, file).Calibration);
                foreach (LidarPoint point in frame.ReadPoints(file))
                {
                    scan._points.Add(toWorld.Apply(toEgo.Apply(new Vector3D(point.X, point.Y, point.Z))));
                    int id = riders.VehicleOf(point.ObjectId)?.Id ?? point.ObjectId;
                    scan._hits[id] = scan._hits.GetValueOrDefault(id) + 1;
                }
            }
        }

        return scan;
    }

    /// <summary>An object with its points: those inside its box as it is written, and those whose rays met it or its rider.</summary>
    public NuScenesObject Count(NuScenesObject item)
    {
        using JsonDocument box = JsonInput.Parse(item.Box);
        return item with
        {
            Points = new NuScenesBox(new JsonFields(box.RootElement)).Count(_points),
            Hits = _hits.GetValueOrDefault(item.Id),
        };
    }

    /// <summary>The points of a moment are named after its first view.</summary>
    private static string SweepOf(ExportFrame frame, Rig rig, RigLidar lidar) =>
        FramePaths.Sweep(frame.Label.Frame - (frame.Label.Frame % rig.Cameras.Count), lidar.Name);

    private static NuScenesMotion MotionOf(string json)
    {
        using JsonDocument document = JsonInput.Parse(json);
        return new NuScenesMotion(new JsonFields(document.RootElement));
    }
}
