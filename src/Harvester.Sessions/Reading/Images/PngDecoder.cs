using System.Buffers.Binary;
using System.IO.Compression;
using System.Numerics;
using System.Runtime.InteropServices;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images;

/// <summary>
/// Reads PNG images (ISO/IEC 15948) of the kinds in sessions and datasets, without interlacing: RGB and greyscale with 16 or 8 bits.
/// </summary>
public static class PngDecoder
{
    private const int SignatureLength = 8;
    private const int HeaderLength = 33;
    private const int TypeAt = 12;
    private const int BitDepthAt = 24;
    private const int ChecksumAt = 29;
    private const byte ColourTypeGrey = 0;
    private const byte ColourTypeRgb = 2;
    private const byte ColourTypePalette = 3;
    private const int BytesPerGreyPixel = 2;
    private const int ComponentsOfColour = 3;

    /// <summary>
    /// Reads an image. The checksums of the header and of the compressed data are verified; <c>harvester validate</c> verifies those of
    /// all chunks.
    /// </summary>
    /// <exception cref="DatasetFormatException">The file is not such an image, or is damaged; the message refers to the file as
    /// "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static PixelBuffer ReadRgb(string path)
    {
        ImageSize size = ImageHeader.Read(path).Size;
        var picture = new PixelBuffer(size);
        Read(path, 8, ColourTypeRgb, "an 8-bit colour", size, PixelBuffer.BytesPerPixel, picture.Bytes);
        return picture;
    }

    /// <summary>Reads an instance mask.</summary>
    /// <exception cref="DatasetFormatException">The file is not such an image, or is damaged; the message refers to the file as
    /// "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static InstanceMap ReadInstanceMap(string path)
    {
        ImageSize size = ImageHeader.Read(path).Size;
        byte[] bytes = new byte[size.PixelCount * BytesPerGreyPixel];
        Read(path, 16, ColourTypeGrey, "a 16-bit greyscale", size, BytesPerGreyPixel, bytes);
        var map = new InstanceMap(size);
        Take(bytes, map.Ids);
        return map;
    }

    /// <summary>Reads a colour image of 16 bits per component, such as a map of flow.</summary>
    /// <returns>Red, green and blue of each pixel, row by row.</returns>
    /// <exception cref="DatasetFormatException">The file is not such an image, or is damaged; the message refers to the file as
    /// "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static ushort[] ReadDeepColour(string path)
    {
        ImageSize size = ImageHeader.Read(path).Size;
        ushort[] components = new ushort[checked(size.PixelCount * ComponentsOfColour)];
        byte[] bytes = new byte[checked(components.Length * 2)];
        Read(path, 16, ColourTypeRgb, "a 16-bit colour", size, ComponentsOfColour * 2, bytes);
        Take(bytes, components);
        return components;
    }

    /// <summary>Reads an 8-bit label map, grey or with a palette.</summary>
    /// <exception cref="DatasetFormatException">The file is not such an image, or is damaged; the message refers to the file as
    /// "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
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

    /// <summary>Takes numbers of which the most significant byte is the first.</summary>
    private static void Take(byte[] bytes, ushort[] numbers)
    {
        ReadOnlySpan<ushort> stored = MemoryMarshal.Cast<byte, ushort>(bytes);
        if (BitConverter.IsLittleEndian)
        {
            BinaryPrimitives.ReverseEndianness(stored, numbers);
        }
        else
        {
            stored.CopyTo(numbers);
        }
    }

    private static void Read(string path, byte bitDepth, byte colourType, string kind, ImageSize size, int bytesPerPixel, byte[] pixels)
    {
        using FileStream file = InputFile.OpenRead(path);
        Span<byte> header = stackalloc byte[HeaderLength];
        file.ReadExactly(header);
        byte[] described = header[TypeAt..ChecksumAt].ToArray();
        if (Crc32.Append(0, described, described.Length) != BinaryPrimitives.ReadUInt32BigEndian(header[ChecksumAt..]))
        {
            throw new DatasetFormatException("its header is damaged.");
        }

        if (header[BitDepthAt] != bitDepth || !IsOf(header[BitDepthAt + 1], colourType) || header[BitDepthAt + 4] != 0)
        {
            throw new DatasetFormatException($"it is not {kind} PNG without interlacing.");
        }

        file.Position = SignatureLength;
        try
        {
            using var rows = new ZLibStream(new PngData(file), CompressionMode.Decompress);
            ReadRows(rows, pixels, size, bytesPerPixel);

            // The end of the data has its checksum.
            if (rows.ReadByte() >= 0)
            {
                throw new InvalidDataException("The data has more rows than the header says.");
            }
        }
        catch (Exception e) when (e is InvalidDataException or EndOfStreamException)
        {
            throw new DatasetFormatException("its pixels are damaged.", e);
        }
    }

    /// <summary>The numbers of a palette are read like those of a grey image.</summary>
    private static bool IsOf(byte found, byte wanted) => found == wanted || (wanted == ColourTypeGrey && found == ColourTypePalette);

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
        switch (filter)
        {
            case 0:
                break;
            case 1:
                for (int i = pixel; i < current.Length; i++)
                {
                    current[i] += current[i - pixel];
                }

                break;
            case 2:
                AddAbove(current, above);
                break;
            case 3:
                for (int i = 0; i < current.Length; i++)
                {
                    current[i] += (byte)(((i >= pixel ? current[i - pixel] : 0) + above[i]) / 2);
                }

                break;
            case 4:
                for (int i = 0; i < current.Length; i++)
                {
                    current[i] += i >= pixel ? (byte)Paeth(current[i - pixel], above[i], above[i - pixel]) : above[i];
                }

                break;
            default:
                throw new InvalidDataException($"PNG has no filter {filter}.");
        }
    }

    private static void AddAbove(Span<byte> current, ReadOnlySpan<byte> above)
    {
        int i = 0;
        for (; i <= current.Length - Vector<byte>.Count; i += Vector<byte>.Count)
        {
            (new Vector<byte>(current[i..]) + new Vector<byte>(above[i..])).CopyTo(current[i..]);
        }

        for (; i < current.Length; i++)
        {
            current[i] += above[i];
        }
    }

    private static int Paeth(int left, int above, int upperLeft)
    {
        int estimate = left + above - upperLeft;
        int toLeft = Math.Abs(estimate - left);
        int toAbove = Math.Abs(estimate - above);
        int toUpperLeft = Math.Abs(estimate - upperLeft);
        return toLeft <= toAbove && toLeft <= toUpperLeft ? left
            : toAbove <= toUpperLeft ? above
            : upperLeft;
    }
}
