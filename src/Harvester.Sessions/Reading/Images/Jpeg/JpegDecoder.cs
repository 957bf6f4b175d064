using Harvester.Sessions.Imaging;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images.Jpeg;

/// <summary>
/// Reads baseline JPEG images (ITU-T T.81, 8 bits, Huffman codes), greyscale or YCbCr. Images without chroma subsampling, as in sessions,
/// have the same pixels as with libjpeg; subsampled chroma is replicated without interpolation.
/// </summary>
public static class JpegDecoder
{
    private const int Colours = 3;

    /// <summary>Reads an image.</summary>
    /// <exception cref="DatasetFormatException">The file is not such an image, or is damaged; the message refers to the file as
    /// "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static PixelBuffer ReadRgb(string path)
    {
        byte[] file = InputFile.ReadAllBytes(path, InputFile.MaxPictureBytes);
        using var stream = new MemoryStream(file);
        try
        {
            List<JpegSegment> header = [.. JpegSegment.ReadHeader(stream)];
            JpegSegment frame = header.Find(segment => segment.IsFrame) ?? throw new InvalidDataException("A picture has a frame.");
            CheckKind(header, frame);
            var tables = new JpegTables();
            header.ForEach(tables.Apply);
            JpegFrame decoded = JpegFrame.Read(frame, header[^1], tables);
            new JpegScan(decoded, tables.RestartInterval, file.AsMemory((int)stream.Position)).Decode();
            return Coloured(decoded);
        }
        catch (Exception e) when (e is InvalidDataException or IndexOutOfRangeException or ArgumentOutOfRangeException)
        {
            throw new DatasetFormatException("its JPEG header is damaged.", e);
        }
    }

    private static void CheckKind(List<JpegSegment> header, JpegSegment frame)
    {
        string? kind = frame.Marker switch
        {
            JpegSegment.BaselineFrame or JpegSegment.ExtendedFrame => null,
            JpegSegment.ProgressiveFrame => "a progressive JPEG",
            _ => "a lossless or arithmetic-coded JPEG",
        };
        kind ??=
            frame.BitsPerSample != 8 ? $"a JPEG of {frame.BitsPerSample} bits per sample"
            : frame.Components is not (1 or Colours) ? $"a JPEG of {frame.Components} components"
            : frame.Components == Colours && header.Exists(IsOfOtherColours) ? "a JPEG that is not in YCbCr"
            : header[^1].Content is [var scanned, ..] && scanned != frame.Components ? "a JPEG of several scans"
            : null;
        if (kind is not null)
        {
            throw new DatasetFormatException(
                $"it is {kind}. Only baseline JPEG pictures of 8 bits in one scan, grey or in YCbCr, can be read; convert it."
            );
        }
    }

    /// <summary>Whether a segment is Adobe's and specifies another colour transform than YCbCr.</summary>
    private static bool IsOfOtherColours(JpegSegment segment)
    {
        const int transformAt = 11;
        const byte yCbCr = 1;
        return segment.Marker == JpegSegment.AdobeData && segment.Content.Length > transformAt && segment.Content[transformAt] != yCbCr;
    }

    private static PixelBuffer Coloured(JpegFrame frame)
    {
        const int neutral = 128;
        const int fractionBits = 16;
        const int half = 1 << (fractionBits - 1);
        var picture = new PixelBuffer(frame.Size);
        bool isGrey = frame.Components.Count == 1;
        int at = 0;
        for (int y = 0; y < frame.Size.Height; y++)
        {
            for (int x = 0; x < frame.Size.Width; x++, at += PixelBuffer.BytesPerPixel)
            {
                int brightness = frame.Sample(0, x, y);
                int cb = isGrey ? 0 : frame.Sample(1, x, y) - neutral;
                int cr = isGrey ? 0 : frame.Sample(2, x, y) - neutral;

                // JFIF 1.02: 1.402 in red, 0.34414 and 0.71414 in green, 1.772 in blue, rounded as in libjpeg.
                picture.Bytes[at] = Clamped(brightness + (((91_881 * cr) + half) >> fractionBits));
                picture.Bytes[at + 1] = Clamped(brightness + (((-22_554 * cb) - (46_802 * cr) + half) >> fractionBits));
                picture.Bytes[at + 2] = Clamped(brightness + (((116_130 * cb) + half) >> fractionBits));
            }
        }

        return picture;
    }

    private static byte Clamped(int value) => (byte)Math.Clamp(value, 0, 255);
}
