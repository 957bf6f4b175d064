using System.Buffers.Binary;
using Foxglove;
using Google.Protobuf;
using Harvester.Sessions.Lidar;
using Element = Foxglove.PackedElementField;
using Kind = Foxglove.PackedElementField.Types.NumericType;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// The message of the points of a LiDAR: x forward, y left, z up of the sensor, metres, and what the file of the session says of each
/// point.
/// </summary>
internal static class PointMessage
{
    private const int Stride = 22;

    /// <summary>The fields in their order, each at the byte where the one before ends.</summary>
    private static readonly (string Name, Kind Kind, int At)[] Fields =
    [
        ("x", Kind.Float32, 0),
        ("y", Kind.Float32, 4),
        ("z", Kind.Float32, 8),
        ("intensity", Kind.Float32, 12),
        ("beam", Kind.Uint16, 16),
        ("object", Kind.Uint16, 18),
        ("class", Kind.Uint8, 20),
        ("interpolated", Kind.Uint8, 21),
    ];

    /// <summary>Writes the message.</summary>
    /// <param name="points">The points.</param>
    /// <param name="frame">Name of the frame of reference of the sensor.</param>
    /// <param name="nanoseconds">The moment, nanoseconds.</param>
    public static byte[] Of(LidarPoint[] points, string frame, long nanoseconds) =>
        new PointCloud
        {
            Timestamp = MessageTime.Of(nanoseconds),
            FrameId = frame,
            Pose = new Pose
            {
                Position = new Vector3(),
                Orientation = new Quaternion { W = 1 },
            },
            PointStride = Stride,
            Fields =
            {
                Fields.Select(field => new Element
                {
                    Name = field.Name,
                    Type = field.Kind,
                    Offset = (uint)field.At,
                }),
            },
            Data = UnsafeByteOperations.UnsafeWrap(DataOf(points)),
        }.ToByteArray();

    private static byte[] DataOf(LidarPoint[] points)
    {
        byte[] data = new byte[points.Length * Stride];
        Span<byte> rest = data;
        foreach (LidarPoint point in points)
        {
            BinaryPrimitives.WriteSingleLittleEndian(rest, point.Y);
            BinaryPrimitives.WriteSingleLittleEndian(rest[4..], -point.X);
            BinaryPrimitives.WriteSingleLittleEndian(rest[8..], point.Z);
            BinaryPrimitives.WriteSingleLittleEndian(rest[12..], point.Intensity);
            BinaryPrimitives.WriteUInt16LittleEndian(rest[16..], point.Beam);
            BinaryPrimitives.WriteUInt16LittleEndian(rest[18..], point.ObjectId);
            rest[20] = (byte)point.Class;
            rest[21] = (byte)(point.IsInterpolated ? 1 : 0);
            rest = rest[Stride..];
        }

        return data;
    }
}
