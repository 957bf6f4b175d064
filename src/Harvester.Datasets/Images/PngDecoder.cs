using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using Harvester.Datasets.Files;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;

namespace Harvester.Datasets.Images;

/// <summary>
/// Reads PNG pictures (ISO/IEC 15948) of the kinds that sessions and datasets have, not interlaced: 8-bit red, green, blue, and grey of 16
/// or 8 bits.
/// </summary>
public static class PngDecoder
{
    private const int SignatureLength = 8;
    private const int HeaderLength = 33;
    private const int BitDepthAt = 24;
    private const byte ColourTypeGrey = 0;
    private const byte ColourTypeRgb = 2;
    private const int BytesPerGreyPixel = 2;

    /// <summary>Reads a picture. Checksums are not looked at: the compressed data has its own.</summary>
    /// <exception cref="DatasetFormatException">It is not such a picture, or damaged; the message speaks of the file as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static PixelBuffer ReadRgb(string path)
    {
        ImageSize size = ImageHeader.Read(path).Size;
        var picture = new PixelBuffer(size);
        Read(path, 8, ColourTypeRgb, "an 8-bit colour", size, PixelBuffer.BytesPerPixel, picture.Bytes);
        return picture;
    }

    /// <summary>Reads an instance mask.</summary>
    /// <exception cref="DatasetFormatException">It is not such a picture, or damaged; the message speaks of the file as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static InstanceMap ReadInstanceMap(string path)
    {
        ImageSize size = ImageHeader.Read(path).Size;
        byte[] bytes = new byte[size.PixelCount * BytesPerGreyPixel];
        Read(path, 16, ColourTypeGrey, "a 16-bit grey", size, BytesPerGreyPixel, bytes);
        var map = new InstanceMap(size);
        for (int i = 0; i < map.Ids.Length; i++)
        {
            map.Ids[i] = BinaryPrimitives.ReadUInt16BigEndian(bytes.AsSpan(i * BytesPerGreyPixel));
        }

        return map;
    }

    /// <summary>Reads a map of labels, 8 bits each.</summary>
    /// <exception cref="DatasetFormatException">It is not such a picture, or damaged; the message speaks of the file as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static InstanceMap ReadLabelMap(string path)
    {
        ImageSize size = ImageHeader.Read(path).Size;
        byte[] bytes = new byte[size.PixelCount];
        Read(path, 8, ColourTypeGrey, "an 8-bit grey", size, 1, bytes);
        var map = new InstanceMap(size);
        for (int i = 0; i < bytes.Length; i++)
        {
            map.Ids[i] = bytes[i];
        }

        return map;
    }

    private static void Read(string path, byte bitDepth, byte colourType, string kind, ImageSize size, int bytesPerPixel, byte[] pixels)
    {
        using FileStream file = InputFile.OpenRead(path);
        Span<byte> header = stackalloc byte[HeaderLength];
        file.ReadExactly(header);
        if (header[BitDepthAt] != bitDepth || header[BitDepthAt + 1] != colourType || header[BitDepthAt + 4] != 0)
        {
            throw new DatasetFormatException($"it is not {kind} PNG without interlace.");
        }

        file.Position = SignatureLength;
        try
        {
            using var rows = new ZLibStream(new PngData(file), CompressionMode.Decompress);
            ReadRows(rows, pixels, size, bytesPerPixel);
        }
        catch (Exception e) when (e is InvalidDataException or EndOfStreamException)
        {
            throw new DatasetFormatException("its pixels are damaged.", e);
        }
    }

    private static void ReadRows(ZLibStream rows, byte[] pixels, ImageSize size, int bytesPerPixel)
    {
        int stride = size.Width * bytesPerPixel;
        byte[] above = new byte[stride];
        for (int row = 0; row < size.Height; row++)
        {
            int filter = rows.ReadByte();
            Span<byte> current = pixels.AsSpan(row * stride, stride);
            rows.ReadExactly(current);
            Unfilter(filter, current, above, bytesPerPixel);
            current.CopyTo(above);
        }
    }

    private static void Unfilter(int filter, Span<byte> current, ReadOnlySpan<byte> above, int pixel)
    {
        for (int i = 0; i < current.Length; i++)
        {
            int left = i >= pixel ? current[i - pixel] : 0;
            int upperLeft = i >= pixel ? above[i - pixel] : 0;
            int predicted = filter switch
            {
                0 => 0,
                1 => left,
                2 => above[i],
                3 => (left + above[i]) / 2,
                4 => Paeth(left, above[i], upperLeft),
                _ => throw new InvalidDataException($"PNG has no filter {filter}."),
            };
            current[i] = (byte)(current[i] + predicted);
        }
    }

    private static int Paeth(int left, int above, int upperLeft)
    {
        int estimate = left + above - upperLeft;
        int toLeft = Math.Abs(estimate - left);
        int toAbove = Math.Abs(estimate - above);
        int toUpperLeft = Math.Abs(estimate - upperLeft);
        return toLeft <= toAbove && toLeft <= toUpperLeft ? left : toAbove <= toUpperLeft ? above : upperLeft;
    }
}
