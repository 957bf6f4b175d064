using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using Harvester.Capture.Imaging;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Images;

/// <summary>Reads PNG pictures (ISO/IEC 15948) of the kind that sessions have: 8-bit red, green, blue, not interlaced.</summary>
public static class PngDecoder
{
    private const int SignatureLength = 8;
    private const int ChunkFrameLength = 12;
    private const byte ColourTypeRgb = 2;

    /// <summary>Reads a picture. Checksums are not looked at: the compressed data has its own.</summary>
    /// <exception cref="DatasetFormatException">It is not such a picture, or damaged; the message speaks of the file as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static PixelBuffer ReadRgb(string path)
    {
        ImageSize size = ImageHeader.Read(path).Size;
        byte[] file = File.ReadAllBytes(path);
        const int bitDepthAt = 24;
        if (file[bitDepthAt] != 8 || file[bitDepthAt + 1] != ColourTypeRgb || file[bitDepthAt + 4] != 0)
        {
            throw new DatasetFormatException("it is not an 8-bit colour PNG without interlace.");
        }

        var picture = new PixelBuffer(size);
        try
        {
            using var rows = new ZLibStream(CompressedData(file), CompressionMode.Decompress);
            ReadRows(rows, picture.Bytes, size);
        }
        catch (Exception e) when (e is InvalidDataException or EndOfStreamException or ArgumentOutOfRangeException)
        {
            throw new DatasetFormatException("its pixels are damaged.", e);
        }

        return picture;
    }

    private static MemoryStream CompressedData(byte[] file)
    {
        var data = new MemoryStream();
        for (int at = SignatureLength; at + ChunkFrameLength <= file.Length;)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
            if (file.AsSpan(at + 4, 4).SequenceEqual("IDAT"u8))
            {
                data.Write(file.AsSpan(at + 8, length));
            }

            at = checked(at + length + ChunkFrameLength);
        }

        data.Position = 0;
        return data;
    }

    private static void ReadRows(ZLibStream rows, byte[] pixels, ImageSize size)
    {
        int stride = size.Width * PixelBuffer.BytesPerPixel;
        byte[] above = new byte[stride];
        for (int row = 0; row < size.Height; row++)
        {
            int filter = rows.ReadByte();
            Span<byte> current = pixels.AsSpan(row * stride, stride);
            rows.ReadExactly(current);
            Unfilter(filter, current, above);
            current.CopyTo(above);
        }
    }

    private static void Unfilter(int filter, Span<byte> current, ReadOnlySpan<byte> above)
    {
        const int pixel = PixelBuffer.BytesPerPixel;
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
