using System.Buffers.Binary;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Motion;

namespace Harvester.Exports.Formats.Flow;

/// <summary>
/// Middlebury's file of flow: the number 202021.25, width and height, then two floating-point numbers of 32 bits for each pixel, to the
/// right and down, row by row; all little-endian (Baker et al., "A Database and Evaluation Methodology for Optical Flow", IJCV 2011).
/// </summary>
internal static class FloFile
{
    /// <summary>Bytes before the first pixel.</summary>
    public const int HeaderBytes = 12;

    /// <summary>Bytes of a pixel.</summary>
    public const int BytesPerPixel = 8;

    /// <summary>The flow of a pixel whose flow is not known; readers take all above 1e9 as unknown.</summary>
    public const float Unknown = 1666666752;

    private const float Magic = 202021.25f;
    private const float MinUnknown = 1e9f;

    /// <summary>Writes the flow of a pair.</summary>
    public static void Write(PairFlow flow, Stream stream)
    {
        byte[] line = new byte[Math.Max(HeaderBytes, flow.Image.Width * BytesPerPixel)];
        BinaryPrimitives.WriteSingleLittleEndian(line, Magic);
        BinaryPrimitives.WriteInt32LittleEndian(line.AsSpan(4), flow.Image.Width);
        BinaryPrimitives.WriteInt32LittleEndian(line.AsSpan(8), flow.Image.Height);
        stream.Write(line, 0, HeaderBytes);
        for (int row = 0, pixel = 0; row < flow.Image.Height; row++)
        {
            for (int at = 0; at < flow.Image.Width * BytesPerPixel; at += BytesPerPixel, pixel++)
            {
                (ushort right, ushort down) = flow.NumbersAt(pixel);
                bool isKnown = flow.IsKnown(pixel);
                BinaryPrimitives.WriteSingleLittleEndian(line.AsSpan(at), isKnown ? (float)FlowUnits.PixelsOf(right) : Unknown);
                BinaryPrimitives.WriteSingleLittleEndian(line.AsSpan(at + 4), isKnown ? (float)FlowUnits.PixelsOf(down) : Unknown);
            }

            stream.Write(line, 0, flow.Image.Width * BytesPerPixel);
        }
    }

    /// <summary>What is wrong with the content of a file; null for nothing.</summary>
    /// <param name="bytes">The content.</param>
    /// <param name="image">The size of its images.</param>
    public static string? ProblemOf(ReadOnlySpan<byte> bytes, ImageSize image)
    {
        if (bytes.Length < HeaderBytes || BinaryPrimitives.ReadSingleLittleEndian(bytes) != Magic)
        {
            return "it does not begin with the number of a file of flow, 202021.25.";
        }

        if (
            BinaryPrimitives.ReadInt32LittleEndian(bytes[4..]) != image.Width
            || BinaryPrimitives.ReadInt32LittleEndian(bytes[8..]) != image.Height
        )
        {
            return "its size is not that of its images.";
        }

        if (bytes.Length != LengthOf(image))
        {
            return $"it does not have {LengthOf(image)} bytes, as its size needs.";
        }

        for (int at = HeaderBytes; at < bytes.Length; at += BytesPerPixel)
        {
            float right = BinaryPrimitives.ReadSingleLittleEndian(bytes[at..]);
            float down = BinaryPrimitives.ReadSingleLittleEndian(bytes[(at + 4)..]);
            if (!IsFlow(right) || !IsFlow(down) || (right > MinUnknown) != (down > MinUnknown))
            {
                return FormattableString.Invariant($"pixel {(at - HeaderBytes) / BytesPerPixel} is neither a flow nor unknown.");
            }
        }

        return null;
    }

    /// <summary>Bytes of a file.</summary>
    public static int LengthOf(ImageSize image) => HeaderBytes + (image.PixelCount * BytesPerPixel);

    private static bool IsFlow(float value) => value > MinUnknown ? float.IsFinite(value) : Math.Abs(value) <= FlowMaker.MaxPixels;
}
