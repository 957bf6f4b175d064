using System.Globalization;

namespace Harvester.Exports.Formats.PointClouds;

/// <summary>A file format of point clouds: a header as text, and then the points as little-endian binary numbers.</summary>
/// <param name="Extension">Extension of its files.</param>
/// <param name="HeaderOf">The header for a number of points.</param>
internal sealed record PointCloudKind(string Extension, Func<int, string> HeaderOf)
{
    /// <summary>Bytes of a point: x, y, z, intensity as float32; ring, object as uint16; class and flag as uint8.</summary>
    public const int BytesPerPoint = 22;

    /// <summary>The format of the Point Cloud Library, version 0.7.</summary>
    public static PointCloudKind Pcd { get; } =
        new(
            ".pcd",
            points =>
                Lines(
                    "# .PCD v0.7 - Point Cloud Data file format",
                    "VERSION 0.7",
                    "FIELDS x y z intensity ring object label interpolated",
                    "SIZE 4 4 4 4 2 2 1 1",
                    "TYPE F F F F U U U U",
                    "COUNT 1 1 1 1 1 1 1 1",
                    $"WIDTH {Text(points)}",
                    "HEIGHT 1",
                    "VIEWPOINT 0 0 0 1 0 0 0",
                    $"POINTS {Text(points)}",
                    "DATA binary"
                )
        );

    /// <summary>Stanford's polygon format, version 1.0.</summary>
    public static PointCloudKind Ply { get; } =
        new(
            ".ply",
            points =>
                Lines(
                    "ply",
                    "format binary_little_endian 1.0",
                    $"element vertex {Text(points)}",
                    "property float x",
                    "property float y",
                    "property float z",
                    "property float intensity",
                    "property ushort ring",
                    "property ushort object",
                    "property uchar label",
                    "property uchar interpolated",
                    "end_header"
                )
        );

    private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);

    private static string Lines(params string[] lines) => string.Join('\n', lines) + "\n";
}
