using Harvester.Sessions.Semantics;

namespace Harvester.Sessions.Lidar;

/// <summary>Reads and writes the file of a sweep: one record per point without a header, little-endian. Fields: docs/rigs.md.</summary>
public static class LidarFile
{
    /// <summary>Length of the record of a point, bytes.</summary>
    public const int BytesPerPoint = 24;

    /// <summary>Maximum number of points of a sweep.</summary>
    public const int MaxPoints = 2_000_000;

    private const byte Interpolated = 1;

    /// <summary>Writes the points of a sweep, a record of 24 bytes each.</summary>
    public static void Write(Stream stream, IReadOnlyList<LidarPoint> points)
    {
        _ = points ?? throw new ArgumentNullException(nameof(points));
        using var bytes = new MemoryStream(points.Count * BytesPerPoint);
        using var writer = new BinaryWriter(bytes);
        foreach (LidarPoint point in points)
        {
            writer.Write(point.X);
            writer.Write(point.Y);
            writer.Write(point.Z);
            writer.Write(point.Intensity);
            writer.Write(point.Column);
            writer.Write(point.Beam);
            writer.Write(point.ObjectId);
            writer.Write((byte)point.Class);
            writer.Write(point.IsInterpolated ? Interpolated : (byte)0);
        }

        writer.Flush();
        bytes.WriteTo(stream ?? throw new ArgumentNullException(nameof(stream)));
    }

    /// <summary>Reads the points of a file.</summary>
    /// <exception cref="FormatException">The content is no sweep; the message says why.</exception>
    public static LidarPoint[] Read(byte[] content)
    {
        _ = content ?? throw new ArgumentNullException(nameof(content));
        if (content.Length % BytesPerPoint != 0)
        {
            throw new FormatException(
                FormattableString.Invariant($"it has {content.Length} bytes, which is no multiple of the {BytesPerPoint} of a point.")
            );
        }

        using var reader = new BinaryReader(new MemoryStream(content));
        var points = new LidarPoint[content.Length / BytesPerPoint];
        for (int i = 0; i < points.Length; i++)
        {
            var point = new LidarPoint(
                reader.ReadSingle(),
                reader.ReadSingle(),
                reader.ReadSingle(),
                reader.ReadSingle(),
                reader.ReadUInt16(),
                reader.ReadUInt16(),
                reader.ReadUInt16(),
                (SemanticClass)reader.ReadByte()
            );
            byte flags = reader.ReadByte();
            points[i] = point with { IsInterpolated = (flags & Interpolated) != 0 };
            if (Problem(point, flags) is { } problem)
            {
                throw new FormatException(FormattableString.Invariant($"point {i} {problem}"));
            }
        }

        return points;
    }

    private static string? Problem(LidarPoint point, byte flags) =>
        !IsFinite(point.X) || !IsFinite(point.Y) || !IsFinite(point.Z) ? "has no finite position."
        : !(point.Intensity >= 0 && point.Intensity <= 1) ? "has an intensity outside 0 to 1."
        : (int)point.Class > SemanticClasses.Greatest ? "has an unknown class."
        : flags > Interpolated ? "has unknown flags."
        : null;

    private static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);
}
