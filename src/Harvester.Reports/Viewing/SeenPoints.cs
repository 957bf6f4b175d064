using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Rigs;

namespace Harvester.Reports.Viewing;

/// <summary>
/// The points of LiDARs as a view shows them, five float32 each, little-endian: pixel u and v, NaN outside the image; metres to the right
/// of and behind the ego, in the horizontal plane; distance from the sensor, metres.
/// </summary>
internal static class SeenPoints
{
    /// <summary>Reads and projects the points.</summary>
    /// <param name="session">The session.</param>
    /// <param name="info">Its session.json, with the rig.</param>
    /// <param name="view">The frame in whose image the points are.</param>
    /// <param name="sweeps">The LiDARs of its moment.</param>
    /// <exception cref="DatasetFormatException">The points cannot be read, or their sensor is unknown.</exception>
    public static byte[] Of(SessionReader session, SessionInfo info, FrameLabel view, IEnumerable<SweepLabel> sweeps)
    {
        Camera camera = LabelCamera.Of(view.Camera);
        EgoLabel ego = view.Ego;
        var vehicle = new Pose(ego.Position, ego.Axes ?? Axes.FromHeading(ego.HeadingDegrees));
        var level = new Pose(ego.Position, Axes.FromHeading(ego.HeadingDegrees));
        using var bytes = new MemoryStream();
        using var writer = new BinaryWriter(bytes);
        foreach (SweepLabel sweep in sweeps)
        {
            RigLidar lidar =
                info.Rig?.Lidars.FirstOrDefault(each => each.Name == sweep.Sensor)
                ?? throw new DatasetFormatException($"the LiDAR '{sweep.Sensor}' is not in the rig of session.json.");
            Pose sensor = vehicle.Compose(info.Rig.OnVehicle(lidar.Mount));
            foreach (LidarPoint point in Read(session, sweep.File))
            {
                var inSensor = new Vector3D(point.X, point.Y, point.Z);
                Vector3D world = sensor.ToWorld(inSensor);
                Projection pixel = camera.Project(world);
                bool isSeen = pixel.Outcome == ProjectionOutcome.InImage;
                writer.Write(isSeen ? (float)pixel.U : float.NaN);
                writer.Write(isSeen ? (float)pixel.V : float.NaN);
                Vector3D onGround = level.ToLocal(world);
                writer.Write((float)onGround.X);
                writer.Write((float)-onGround.Y);
                writer.Write((float)inSensor.Length);
            }
        }

        writer.Flush();
        return bytes.ToArray();
    }

    private static LidarPoint[] Read(SessionReader session, string file)
    {
        try
        {
            return LidarFile.Read(InputFile.ReadAllBytes(session.PathOf(file), LidarFile.MaxPoints * LidarFile.BytesPerPoint));
        }
        catch (FormatException e)
        {
            throw new DatasetFormatException($"{file}: {e.Message}", e);
        }
    }
}
