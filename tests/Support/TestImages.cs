using System.Buffers.Binary;
using System.IO.Compression;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.TestSupport;

/// <summary>Black image files.</summary>
internal static class TestImages
{
    private static readonly byte[] Signature = [0x89, .. "PNG\r\n"u8, 0x1A, 0x0A];

    public static byte[] Png(int width, int height, byte bitDepth = 8, byte colourType = 2)
    {
        int bitsPerPixel = bitDepth * (colourType == 2 ? 3 : 1);
        using var data = new MemoryStream();
        using (var rows = new ZLibStream(data, CompressionLevel.Optimal, leaveOpen: true))
        {
            rows.Write(new byte[height * (1 + (((width * bitsPerPixel) + 7) / 8))]);
        }

        return [.. Signature, .. Header(width, height, bitDepth, colourType), .. Chunk("IDAT"u8, data.ToArray()), .. Chunk("IEND"u8, [])];
    }

    public static byte[] PngWithoutPixels(int width, int height, byte bitDepth = 8, byte colourType = 2) =>
        [.. Signature, .. Header(width, height, bitDepth, colourType), .. Chunk("IEND"u8, [])];

    public static byte[] Bmp(int width, int height)
    {
        byte[] bmp = new byte[54 + (Math.Abs(height) * (((width * 3) + 3) / 4 * 4))];
        bmp[0] = (byte)'B';
        bmp[1] = (byte)'M';
        BinaryPrimitives.WriteInt32LittleEndian(bmp.AsSpan(2), bmp.Length);
        BinaryPrimitives.WriteInt32LittleEndian(bmp.AsSpan(10), 54);
        BinaryPrimitives.WriteInt32LittleEndian(bmp.AsSpan(14), 40);
        BinaryPrimitives.WriteInt32LittleEndian(bmp.AsSpan(18), width);
        BinaryPrimitives.WriteInt32LittleEndian(bmp.AsSpan(22), height);
        BinaryPrimitives.WriteInt16LittleEndian(bmp.AsSpan(26), 1);
        BinaryPrimitives.WriteInt16LittleEndian(bmp.AsSpan(28), 24);
        return bmp;
    }

    private static byte[] Header(int width, int height, byte bitDepth, byte colourType)
    {
        byte[] header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        header[8] = bitDepth;
        header[9] = colourType;
        return Chunk("IHDR"u8, header);
    }

    private static byte[] Chunk(ReadOnlySpan<byte> type, byte[] content)
    {
        byte[] named = [.. type, .. content];
        byte[] chunk = [0, 0, 0, 0, .. named, 0, 0, 0, 0];
        BinaryPrimitives.WriteInt32BigEndian(chunk, content.Length);
        BinaryPrimitives.WriteUInt32BigEndian(chunk.AsSpan(chunk.Length - 4), Crc32.Append(0, named, named.Length));
        return chunk;
    }
}
