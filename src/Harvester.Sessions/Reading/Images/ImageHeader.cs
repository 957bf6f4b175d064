using System.Buffers.Binary;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images.Jpeg;

namespace Harvester.Sessions.Reading.Images;

/// <summary>The header of an image file.</summary>
/// <param name="MediaType">image/png, image/bmp or image/jpeg.</param>
/// <param name="Size">Width and height, pixels.</param>
/// <param name="BitsPerPixel">Bits per pixel, of all channels.</param>
public sealed record ImageHeader(string MediaType, ImageSize Size, int BitsPerPixel)
{
    /// <summary>Media type of PNG.</summary>
    public const string Png = "image/png";

    /// <summary>Media type of Windows bitmaps.</summary>
    public const string Bmp = "image/bmp";

    /// <summary>Media type of JPEG.</summary>
    public const string Jpeg = "image/jpeg";

    private const int PngHeaderLength = 33;
    private const int BmpHeaderLength = 30;

    private static ReadOnlySpan<byte> PngSignature => [0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A];

    private static ReadOnlySpan<byte> JpegStart => [0xFF, JpegSegment.StartOfImage, 0xFF];

    private static ReadOnlySpan<byte> JpegEnd => [0xFF, JpegSegment.EndOfImage];

    private static ReadOnlySpan<byte> PngEnd => [0, 0, 0, 0, (byte)'I', (byte)'E', (byte)'N', (byte)'D', 0xAE, 0x42, 0x60, 0x82];

    /// <summary>Reads the header of a PNG, BMP or JPEG file and checks that the file is not truncated.</summary>
    /// <exception cref="DatasetFormatException">The file has another format, or is truncated; the message refers to the file as
    /// "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static ImageHeader Read(string path)
    {
        using FileStream file = InputFile.OpenRead(path);
        return Read(file);
    }

    /// <summary>As <see cref="Read(string)"/>, for a stream that contains only the image.</summary>
    /// <exception cref="DatasetFormatException">The file has another format, or is truncated; the message refers to the file as
    /// "it".</exception>
    /// <exception cref="IOException">The stream cannot be read.</exception>
    public static ImageHeader Read(Stream file)
    {
        Span<byte> start = stackalloc byte[PngHeaderLength];
        int length = file.ReadAtLeast(start, start.Length, throwOnEndOfStream: false);
        start = start[..length];
        if (length == PngHeaderLength && start.StartsWith(PngSignature))
        {
            return ReadPng(start, file);
        }

        if (start.StartsWith(JpegStart))
        {
            return ReadJpeg(file);
        }

        return length >= BmpHeaderLength && start.StartsWith("BM"u8)
            ? ReadBmp(start, file)
            : throw new DatasetFormatException("it is not a PNG, BMP or JPEG file, or is cut off.");
    }

    private static ImageHeader ReadPng(ReadOnlySpan<byte> start, Stream file)
    {
        if (!EndsWith(file, PngEnd))
        {
            throw new DatasetFormatException("it is cut off: the PNG file has no end.");
        }

        // The IHDR chunk: width, height, bit depth, colour type.
        int channels = start[25] switch
        {
            2 => 3,
            4 => 2,
            6 => 4,
            _ => 1,
        };
        return new ImageHeader(
            Png,
            DeclaredSize.Of(BinaryPrimitives.ReadUInt32BigEndian(start[16..]), BinaryPrimitives.ReadUInt32BigEndian(start[20..])),
            start[24] * channels
        );
    }

    private static ImageHeader ReadBmp(ReadOnlySpan<byte> start, Stream file)
    {
        uint length = BinaryPrimitives.ReadUInt32LittleEndian(start[2..]);
        if (file.Length < length)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"it is cut off: the BMP file has {file.Length} of {length} bytes.")
            );
        }

        // The height is negative if the rows are top-down.
        return new ImageHeader(
            Bmp,
            DeclaredSize.Of(
                BinaryPrimitives.ReadInt32LittleEndian(start[18..]),
                Math.Abs((long)BinaryPrimitives.ReadInt32LittleEndian(start[22..]))
            ),
            BinaryPrimitives.ReadUInt16LittleEndian(start[28..])
        );
    }

    private static ImageHeader ReadJpeg(Stream file)
    {
        if (!EndsWith(file, JpegEnd))
        {
            throw new DatasetFormatException("it is cut off: the JPEG file has no end.");
        }

        file.Seek(0, SeekOrigin.Begin);
        JpegSegment frame =
            JpegSegment.ReadHeader(file).FirstOrDefault(segment => segment.IsFrame)
            ?? throw new DatasetFormatException("its JPEG header does not give its size.");
        return new ImageHeader(Jpeg, frame.Size, frame.BitsPerSample * frame.Components);
    }

    private static bool EndsWith(Stream file, ReadOnlySpan<byte> expected)
    {
        Span<byte> end = stackalloc byte[expected.Length];
        file.Seek(-end.Length, SeekOrigin.End);
        file.ReadExactly(end);
        return end.SequenceEqual(expected);
    }
}
