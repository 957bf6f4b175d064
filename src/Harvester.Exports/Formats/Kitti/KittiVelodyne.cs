using System.Text;
using Harvester.Geometry;
using Harvester.Sessions.Files;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// The points of a rig's first LiDAR, in KITTI's frame of the laser scanner (x forward, y left, z up), and its place beside a camera.
/// </summary>
internal sealed class KittiVelodyne
{
    private readonly ExportFrame _frame;
    private readonly Rig _rig;
    private readonly string _file;

    private KittiVelodyne(ExportFrame frame, Rig rig)
    {
        (_frame, _rig) = (frame, rig);

        // The points of a moment are named in the line of its first view.
        int first = frame.Label.Frame - (frame.Label.Frame % rig.Cameras.Count);
        _file = FramePaths.Sweep(first, rig.Lidars[0].Name);
    }

    /// <summary>The motion, row by row, from the frame of the laser scanner to that of a camera: x right, y down, z forward.</summary>
    /// <param name="camera">The camera's mount on the vehicle.</param>
    public double[] ToCamera(Pose camera)
    {
        Pose lidar = _rig.Lidars[0].Mount;
        Vector3D[] columns =
        [
            camera.Axes.ToLocal(lidar.Axes.Forward),
            camera.Axes.ToLocal(lidar.Axes.Right * -1),
            camera.Axes.ToLocal(lidar.Axes.Up),
            camera.ToLocal(lidar.Position),
        ];
        return [.. columns.Select(column => column.X), .. columns.Select(column => -column.Z), .. columns.Select(column => column.Y)];
    }

    /// <summary>Tr_imu_to_velo, row by row: from the inertial unit at the origin of the vehicle's model to the laser scanner.</summary>
    public double[] FromInertial
    {
        get
        {
            Pose lidar = _rig.OnVehicle(_rig.Lidars[0].Mount);
            Vector3D[] columns =
            [
                EgoTrack.InBody(lidar.Axes, new Vector3D(0, 1, 0)),
                EgoTrack.InBody(lidar.Axes, new Vector3D(-1, 0, 0)),
                EgoTrack.InBody(lidar.Axes, new Vector3D(0, 0, 1)),
                EgoTrack.InBody(lidar.Axes, lidar.Position * -1),
            ];
            return [.. columns.Select(column => column.X), .. columns.Select(column => column.Y), .. columns.Select(column => column.Z)];
        }
    }

    /// <summary>The points at a frame; null if its session has none of that moment.</summary>
    public static KittiVelodyne? Of(ExportFrame frame)
    {
        if (frame.Rig is not { Lidars.Count: > 0 } rig)
        {
            return null;
        }

        var points = new KittiVelodyne(frame, rig);
        return frame.HasFile(points._file) ? points : null;
    }

    /// <summary>Writes SemanticKITTI's label of each point.</summary>
    public void WriteLabels(Stream stream) =>
        SemanticKittiLabels.Write(stream, _frame.ReadPoints(_file), MovingObjects.At(_frame), Riders.At(_frame));

    /// <summary>Writes the points: four float32 each, x, y, z and reflectance from 0 to 1.</summary>
    public void Write(Stream stream)
    {
        using var writer = new BinaryWriter(stream, Encoding.UTF8, leaveOpen: true);
        foreach (LidarPoint point in _frame.ReadPoints(_file))
        {
            writer.Write(point.Y);
            writer.Write(-point.X);
            writer.Write(point.Z);
            writer.Write(point.Intensity);
        }
    }
}
