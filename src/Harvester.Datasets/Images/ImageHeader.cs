using System;
using System.Buffers.Binary;
using System.IO;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Images;

/// <summary>What an image file says of itself in its first bytes.</summary>
/// <param name="MediaType">image/png or image/bmp.</param>
/// <param name="Size">Width and height, pixels.</param>
/// <param name="BitsPerPixel">Bits of one pixel, all channels together.</param>
public sealed record ImageHeader(string MediaType, ImageSize Size, int BitsPerPixel)
{
    private const int PngHeaderLength = 33;
    private const int BmpHeaderLength = 30;

    private static ReadOnlySpan<byte> PngSignature => [0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A];

    private static ReadOnlySpan<byte> PngEnd => [0, 0, 0, 0, (byte)'I', (byte)'E', (byte)'N', (byte)'D', 0xAE, 0x42, 0x60, 0x82];

    /// <summary>Reads the header of a PNG or BMP file and looks whether the file reaches to its end.</summary>
    /// <exception cref="DatasetFormatException">It is neither, or cut off; the message speaks of the file as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static ImageHeader Read(string path)
    {
        using FileStream file = File.OpenRead(path);
        return Read(file);
    }

    /// <summary>Reads the header of a PNG or BMP file in a stream that is it and nothing else.</summary>
    /// <exception cref="DatasetFormatException">It is neither, or cut off; the message speaks of the file as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static ImageHeader Read(Stream file)
    {
        Span<byte> start = stackalloc byte[PngHeaderLength];
        int length = file.ReadAtLeast(start, start.Length, throwOnEndOfStream: false);
        start = start[..length];
        if (length == PngHeaderLength && start.StartsWith(PngSignature))
        {
            return ReadPng(start, file);
        }

        return length >= BmpHeaderLength && start.StartsWith("BM"u8)
            ? ReadBmp(start, file)
            : throw new DatasetFormatException("it is neither a PNG nor a BMP file, or cut off.");
    }

    private static ImageHeader ReadPng(ReadOnlySpan<byte> start, Stream file)
    {
        Span<byte> end = stackalloc byte[PngEnd.Length];
        file.Seek(-end.Length, SeekOrigin.End);
        file.ReadExactly(end);
        if (!end.SequenceEqual(PngEnd))
        {
            throw new DatasetFormatException("it is cut off: the PNG file has no end.");
        }

        // The IHDR chunk: width, height, bit depth, colour type.
        int channels = start[25] switch { 2 => 3, 4 => 2, 6 => 4, _ => 1 };
        return new ImageHeader(
            "image/png",
            SizeOf(BinaryPrimitives.ReadUInt32BigEndian(start[16..]), BinaryPrimitives.ReadUInt32BigEndian(start[20..])),
            start[24] * channels);
    }

    private static ImageHeader ReadBmp(ReadOnlySpan<byte> start, Stream file)
    {
        uint length = BinaryPrimitives.ReadUInt32LittleEndian(start[2..]);
        if (file.Length < length)
        {
            throw new DatasetFormatException(FormattableString.Invariant($"it is cut off: the BMP file has {file.Length} of {length} bytes."));
        }

        // The height is negative when the rows run from the top.
        return new ImageHeader(
            "image/bmp",
            SizeOf(BinaryPrimitives.ReadInt32LittleEndian(start[18..]), Math.Abs((long)BinaryPrimitives.ReadInt32LittleEndian(start[22..]))),
            BinaryPrimitives.ReadUInt16LittleEndian(start[28..]));
    }

    private static ImageSize SizeOf(long width, long height) =>
        width is >= 1 and <= ushort.MaxValue && height is >= 1 and <= ushort.MaxValue
            ? new ImageSize((int)width, (int)height)
            : throw new DatasetFormatException(FormattableString.Invariant($"its header gives the impossible size {width} x {height}."));
}
