using System.IO.Compression;
using System.Text;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Sessions.Imaging.Pictures;

/// <summary>
/// Writes PNG images (ISO/IEC 15948): red, green and blue of 8 or 16 bits, grey of 16 or 8 bits, and 8 bits with a palette. Rows of colours
/// are filtered with Sub and those of maps with Up, the cheapest of the filters that help. One encoder serves one thread; its buffers are
/// reused.
/// </summary>
#pragma warning disable CA1001 // A memory stream holds nothing to dispose.
public sealed class PngEncoder
#pragma warning restore CA1001
{
    private const byte FilterSub = 1;
    private const byte FilterUp = 2;
    private const byte BitsOfGrey = 16;
    private const byte BitsOfDeepColour = 16;
    private const byte BitsOfColour = 8;
    private const byte ColourTypeGrey = 0;
    private const byte ColourTypeRgb = 2;
    private const byte ColourTypePalette = 3;
    private static readonly byte[] Signature = [0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A];

    private readonly CompressionLevel _level;
    private readonly MemoryStream _compressed = new();
    private byte[] _filtered = [];

    /// <summary>Creates an encoder with buffers of its own.</summary>
    /// <param name="level">The compression level; fastest by default, as the encoder's time limits a harvest.</param>
    public PngEncoder(CompressionLevel level = CompressionLevel.Fastest)
    {
        _level = level;
    }

    /// <summary>Writes a colour image.</summary>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void Write(PixelBuffer picture, Stream target)
    {
        if (picture is null)
        {
            throw new ArgumentNullException(nameof(picture));
        }

        int stride = picture.Size.Width * PixelBuffer.BytesPerPixel;
        Write(
            target,
            picture.Size,
            BitsOfColour,
            ColourTypeRgb,
            stride,
            (row, line) => Buffer.BlockCopy(picture.Bytes, row * stride, line, 0, stride)
        );
    }

    /// <summary>Writes an instance map: grey, 16 bits per pixel, the value is the object's number.</summary>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void Write(InstanceMap map, Stream target)
    {
        if (map is null)
        {
            throw new ArgumentNullException(nameof(map));
        }

        int width = map.Image.Width;
        ushort[] ids = map.Ids;
        Write(
            target,
            map.Image,
            BitsOfGrey,
            ColourTypeGrey,
            width * 2,
            (row, line) =>
            {
                for (int at = 0, pixel = row * width; at < line.Length; at += 2, pixel++)
                {
                    ushort id = ids[pixel];
                    line[at] = (byte)(id >> 8);
                    line[at + 1] = (byte)id;
                }
            }
        );
    }

    /// <summary>Writes a map of small numbers: grey, 8 bits per pixel.</summary>
    /// <exception cref="ArgumentException">A number is greater than 255.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void WriteGrey8(InstanceMap map, Stream target)
    {
        if (map is null)
        {
            throw new ArgumentNullException(nameof(map));
        }

        if (Array.Exists(map.Ids, static id => id > byte.MaxValue))
        {
            throw new ArgumentException("The numbers of a map of 8 bits are 0 to 255.", nameof(map));
        }

        Write8(map, ColourTypeGrey, null, target);
    }

    /// <summary>Writes a grey image of 8 bits per pixel that need not be in memory.</summary>
    /// <param name="size">Its size.</param>
    /// <param name="readRow">Fills a row, by its number from the top; the row has what it was last filled with.</param>
    /// <param name="target">Receives the image.</param>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void WriteGrey8(ImageSize size, Action<int, byte[]> readRow, Stream target) =>
        Write(target, size, BitsOfColour, ColourTypeGrey, size.Width, readRow ?? throw new ArgumentNullException(nameof(readRow)));

    /// <summary>Writes a colour image of 16 bits per component, most significant byte first, that need not be in memory.</summary>
    /// <param name="size">Its size.</param>
    /// <param name="readRow">Fills all bytes of a row, six per pixel, by its number from the top.</param>
    /// <param name="target">Receives the image.</param>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void WriteDeepColour(ImageSize size, Action<int, byte[]> readRow, Stream target) =>
        Write(
            target,
            size,
            BitsOfDeepColour,
            ColourTypeRgb,
            size.Width * 2 * PixelBuffer.BytesPerPixel,
            readRow ?? throw new ArgumentNullException(nameof(readRow))
        );

    /// <summary>Writes a map of small numbers with a palette: 8 bits per pixel.</summary>
    /// <param name="map">The map.</param>
    /// <param name="palette">The colour of each number; at most 256.</param>
    /// <param name="target">Receives the image.</param>
    /// <exception cref="ArgumentException">A number has no colour, or there are too many colours.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void WriteIndexed(InstanceMap map, IReadOnlyList<(byte Red, byte Green, byte Blue)> palette, Stream target)
    {
        if (map is null)
        {
            throw new ArgumentNullException(nameof(map));
        }

        if (palette is null)
        {
            throw new ArgumentNullException(nameof(palette));
        }

        if (palette.Count > byte.MaxValue + 1 || Array.Exists(map.Ids, id => id >= palette.Count))
        {
            throw new ArgumentException("A palette has at most 256 colours, and one for each number of the map.", nameof(palette));
        }

        byte[] colours = new byte[palette.Count * PixelBuffer.BytesPerPixel];
        for (int i = 0; i < palette.Count; i++)
        {
            (colours[i * 3], colours[(i * 3) + 1], colours[(i * 3) + 2]) = palette[i];
        }

        Write8(map, ColourTypePalette, colours, target);
    }

    private void Write8(InstanceMap map, byte colourType, byte[]? palette, Stream target)
    {
        int width = map.Image.Width;
        Write(
            target,
            map.Image,
            8,
            colourType,
            width,
            (row, line) =>
            {
                for (int column = 0; column < width; column++)
                {
                    line[column] = (byte)map.Ids[(row * width) + column];
                }
            },
            palette
        );
    }

    private void Write(
        Stream target,
        ImageSize size,
        byte bits,
        byte colourType,
        int stride,
        Action<int, byte[]> readRow,
        byte[]? palette = null
    )
    {
        if (target is null)
        {
            throw new ArgumentNullException(nameof(target));
        }

        target.Write(Signature, 0, Signature.Length);
        byte[] header = new byte[13];
        WriteBigEndian(header, 0, (uint)size.Width);
        WriteBigEndian(header, 4, (uint)size.Height);
        header[8] = bits;
        header[9] = colourType;
        WriteChunk(target, "IHDR", header, header.Length);
        if (palette is not null)
        {
            WriteChunk(target, "PLTE", palette, palette.Length);
        }

        Compress(size.Height, stride, colourType == ColourTypeRgb ? stride / size.Width : 0, readRow);
        WriteChunk(target, "IDAT", _compressed.GetBuffer(), (int)_compressed.Length);
        WriteChunk(target, "IEND", [], 0);
    }

    /// <param name="rows">Number of rows.</param>
    /// <param name="stride">Bytes of a row.</param>
    /// <param name="pixel">Bytes of a pixel whose rows are filtered with Sub; 0 for Up.</param>
    /// <param name="readRow">Fills a row.</param>
    private void Compress(int rows, int stride, int pixel, Action<int, byte[]> readRow)
    {
        _filtered = _filtered.Length == stride + 1 ? _filtered : new byte[stride + 1];
        _filtered[0] = pixel > 0 ? FilterSub : FilterUp;
        byte[] above = new byte[stride];
        byte[] current = new byte[stride];
        _compressed.SetLength(0);
        using var zlib = new ZlibWriter(_compressed, _level);
        for (int row = 0; row < rows; row++)
        {
            readRow(row, current);
            if (pixel > 0)
            {
                // Sub: each byte minus that of the pixel on its left; the first pixel has none.
                Buffer.BlockCopy(current, 0, _filtered, 1, pixel);
                RowDifference.Write(current, pixel, current, 0, _filtered, pixel + 1);
            }
            else
            {
                // Up: each byte minus the one above it; above the first row are zeros.
                RowDifference.Write(current, 0, above, 0, _filtered, 1);
            }

            zlib.Write(_filtered, _filtered.Length);
            (above, current) = (current, above);
        }
    }

    private static void WriteChunk(Stream target, string type, byte[] data, int length)
    {
        byte[] frame = new byte[4];
        byte[] name = Encoding.ASCII.GetBytes(type);
        WriteBigEndian(frame, 0, (uint)length);
        target.Write(frame, 0, frame.Length);
        target.Write(name, 0, name.Length);
        target.Write(data, 0, length);
        WriteBigEndian(frame, 0, Crc32.Append(Crc32.Append(0, name, name.Length), data, length));
        target.Write(frame, 0, frame.Length);
    }

    private static void WriteBigEndian(byte[] target, int offset, uint value)
    {
        target[offset] = (byte)(value >> 24);
        target[offset + 1] = (byte)(value >> 16);
        target[offset + 2] = (byte)(value >> 8);
        target[offset + 3] = (byte)value;
    }
}
