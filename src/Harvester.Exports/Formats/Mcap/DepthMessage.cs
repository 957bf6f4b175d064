using System.Buffers.Binary;
using Foxglove;
using Google.Protobuf;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>The message of a depth map, encoded as 32FC1: metres along the optical axis, NaN where there is no depth.</summary>
internal static class DepthMessage
{
    /// <summary>The values of a depth map in a metre.</summary>
    private const float PerMetre = 256;

    /// <summary>Writes the message.</summary>
    /// <param name="map">The map, with 256 values in a metre and 0 for none.</param>
    /// <param name="frame">Name of the frame of reference of the camera.</param>
    /// <param name="nanoseconds">The moment, nanoseconds.</param>
    public static byte[] Of(InstanceMap map, string frame, long nanoseconds)
    {
        byte[] data = new byte[map.Ids.Length * sizeof(float)];
        for (int i = 0; i < map.Ids.Length; i++)
        {
            float metres = map.Ids[i] == 0 ? float.NaN : map.Ids[i] / PerMetre;
            BinaryPrimitives.WriteSingleLittleEndian(data.AsSpan(i * sizeof(float)), metres);
        }

        return new RawImage
        {
            Timestamp = MessageTime.Of(nanoseconds),
            FrameId = frame,
            Width = (uint)map.Image.Width,
            Height = (uint)map.Image.Height,
            Encoding = "32FC1",
            Step = (uint)(map.Image.Width * sizeof(float)),
            Data = UnsafeByteOperations.UnsafeWrap(data),
        }.ToByteArray();
    }
}
