using System.Globalization;
using System.Text;
using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>
/// Writes the detections of a radar as nuScenes' PCD files: eighteen fields a point, in the sensor's frame with x forward and y left. See
/// docs/exports/nuscenes.md.
/// </summary>
internal static class NuScenesRadar
{
    /// <summary>Targets that are slower over the ground count as standing, m/s.</summary>
    private const double StandingSpeed = 0.1;

    /// <summary>More than a radar of a rig detects.</summary>
    public const int MaxBytes = 1_000_000;

    private const int BytesPerPoint = 43;
    private const sbyte Moving = 0;
    private const sbyte Stationary = 1;
    private const sbyte Oncoming = 2;

    /// <summary>The Doppler ambiguity is resolved.</summary>
    private const sbyte Unambiguous = 3;

    /// <summary>The least probability of a false alarm.</summary>
    private const sbyte Sure = 1;

    private static ReadOnlySpan<byte> Counted => "\nPOINTS "u8;

    /// <summary>Writes a file.</summary>
    public static void Write(Stream stream, RadarScan scan)
    {
        // The devkit's reader knows an empty cloud by a first point that is not a number.
        int points = Math.Max(1, scan.Detections.Count);
        using var writer = new BinaryWriter(stream, Encoding.UTF8, leaveOpen: true);
        writer.Write(Encoding.ASCII.GetBytes(HeaderOf(points)));
        if (scan.Detections.Count == 0)
        {
            Write(writer, new RadarDetection(double.NaN, 0, 0, 0, 0, 0, 0, RadarOrigin.Target), 0);
        }

        for (int at = 0; at < scan.Detections.Count; at++)
        {
            Write(writer, scan.Detections[at], (short)at);
        }

        // That reader also asks for a byte after the last point.
        writer.Write((byte)'\n');
    }

    /// <summary>Whether a file has the header of this writer and as many points as that says.</summary>
    public static bool IsWhole(ReadOnlySpan<byte> content)
    {
        // The header counts the points in the line before its last.
        int at = content.IndexOf(Counted) + Counted.Length;
        int end = at < Counted.Length ? -1 : content[at..].IndexOf((byte)'\n');
        if (end < 0 || !int.TryParse(content.Slice(at, end), NumberStyles.None, CultureInfo.InvariantCulture, out int points))
        {
            return false;
        }

        byte[] header = Encoding.ASCII.GetBytes(HeaderOf(points));
        return content.StartsWith(header) && content.Length == header.Length + ((long)points * BytesPerPoint) + 1;
    }

    private static string HeaderOf(int points) =>
        string.Join(
            '\n',
            "# .PCD v0.7 - Point Cloud Data file format",
            "VERSION 0.7",
            "FIELDS x y z dyn_prop id rcs vx vy vx_comp vy_comp is_quality_valid ambig_state x_rms y_rms invalid_state pdh0 vx_rms vy_rms",
            "SIZE 4 4 4 1 2 4 4 4 4 4 1 1 1 1 1 1 1 1",
            "TYPE F F F I I F F F F F I I I I I I I I",
            "COUNT 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1",
            $"WIDTH {Numbers.Text(points)}",
            "HEIGHT 1",
            "VIEWPOINT 0 0 0 1 0 0 0",
            $"POINTS {Numbers.Text(points)}",
            "DATA binary\n"
        );

    private static void Write(BinaryWriter writer, RadarDetection detection, short id)
    {
        (double sine, double cosine) = Math.SinCos(Angles.ToRadians(detection.AzimuthDegrees));

        // These radars do not measure elevation: the point lies in the plane of the sensor.
        writer.Write((float)(detection.Range * cosine));
        writer.Write((float)(detection.Range * sine));
        writer.Write(0f);
        writer.Write(
            Math.Abs(detection.GroundVelocity) < StandingSpeed ? Stationary
            : detection.GroundVelocity < 0 ? Oncoming
            : Moving
        );
        writer.Write(id);
        writer.Write((float)detection.CrossSection);
        writer.Write((float)(detection.RadialVelocity * cosine));
        writer.Write((float)(detection.RadialVelocity * sine));
        writer.Write((float)(detection.GroundVelocity * cosine));
        writer.Write((float)(detection.GroundVelocity * sine));
        writer.Write((sbyte)1);
        writer.Write(Unambiguous);
        writer.Write((sbyte)0);
        writer.Write((sbyte)0);
        writer.Write((sbyte)0);
        writer.Write(Sure);
        writer.Write((sbyte)0);
        writer.Write((sbyte)0);
    }
}
