using System.Text;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Formats.PointClouds;

/// <summary>Writes the points of the LiDARs as PCD or PLY files, and a table of them. See docs/exports/point-clouds.md.</summary>
internal sealed class PointCloudWriter(PointCloudKind kind) : IDatasetWriter
{
    /// <summary>The table of clouds.</summary>
    public const string Clouds = "clouds.csv";

    /// <summary>Its first line.</summary>
    public const string CloudColumns = "file,frame,split,session,session_frame,time_seconds,sensor,points,x,y,z,qw,qx,qy,qz";

    private const string CloudPart = "cloud";
    private const int TimeDecimals = 6;
    private const int MetreDecimals = 4;
    private const int QuaternionDecimals = 9;

    /// <summary>The folder of all clouds; each sensor has one within it.</summary>
    public const string Folder = "clouds";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string time = Numbers.Row(TimeDecimals, frame.Label.TimeSeconds);
        foreach (SweepLabel sweep in frame.Label.Lidar)
        {
            RigLidar lidar =
                frame.Rig?.Lidars.FirstOrDefault(each => each.Name == sweep.Sensor)
                ?? throw frame.Problem($"its LiDAR '{sweep.Sensor}' is not in the rig.");
            LidarPoint[] points = frame.ReadPoints(sweep);
            string file = $"{Folder}/{lidar.Name}/{frame.Name}{kind.Extension}";
            output.File(file, stream => Write(stream, points));
            EgoLabel ego = frame.Label.Ego;
            Pose pose = new Pose(ego.Position, ego.Axes ?? Axes.FromHeading(ego.HeadingDegrees)).Compose(frame.Rig.OnVehicle(lidar.Mount));
            Rotation rotation = Rotation.OfBody(pose.Axes);
            string[] numbers =
            [
                Numbers.Row(MetreDecimals, pose.Position.X, pose.Position.Y, pose.Position.Z),
                Numbers.Row(QuaternionDecimals, rotation.W, rotation.X, rotation.Y, rotation.Z),
            ];
            output.Part(
                CloudPart,
                FormattableString.Invariant(
                    $"{file},{frame.Index},{frame.Split},{frame.RecordingIndex},{frame.Label.Frame},{time},{lidar.Name},{points.Length},"
                ) + string.Join(' ', numbers).Replace(' ', ',')
            );
        }

        return new WrittenObjects(0);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        [new(Clouds, [AggregateSection.Literal(CloudColumns + "\n"), AggregateSection.Lines(CloudPart)])];

    /// <summary>Writes the points with x forward, y left and z up.</summary>
    private void Write(Stream stream, LidarPoint[] points)
    {
        using var writer = new BinaryWriter(stream, Encoding.UTF8, leaveOpen: true);
        writer.Write(Encoding.ASCII.GetBytes(kind.HeaderOf(points.Length)));
        foreach (LidarPoint point in points)
        {
            writer.Write(point.Y);
            writer.Write(-point.X);
            writer.Write(point.Z);
            writer.Write(point.Intensity);
            writer.Write(point.Beam);
            writer.Write(point.ObjectId);
            writer.Write((byte)point.Class);
            writer.Write((byte)(point.IsInterpolated ? 1 : 0));
        }
    }
}
