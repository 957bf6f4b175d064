using System.Buffers.Binary;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Sessions.Tests.Imaging;

public sealed class BmpEncoderTests
{
    /// <summary>Where the format keeps the file's size, the pixels' place, the second header's size, width and height.</summary>
    private static readonly int[] HeaderOffsets = [2, 10, 14, 18, 22];

    [Fact]
    public void Write_two_by_two_gives_the_bytes_of_the_format()
    {
        var picture = new PixelBuffer(new ImageSize(2, 2));
        // Upper row: (1, 2, 3) (4, 5, 6); lower row: (7, 8, 9) (10, 11, 12).
        for (byte i = 0; i < 12; i++)
        {
            picture.Bytes[i] = (byte)(i + 1);
        }

        byte[] file = Encode(picture);

        // 54 bytes of header; 2 rows of 6 bytes, each padded to 8, the lower one first, blue first.
        Assert.Equal(70, file.Length);
        Assert.Equal("BM"u8.ToArray(), file[..2]);
        Assert.Equal([70, 54, 40, 2, 2], HeaderOffsets.Select(offset => BinaryPrimitives.ReadInt32LittleEndian(file.AsSpan(offset))));
        Assert.Equal([1, 0, 24, 0, 0, 0, 0, 0, 16, 0, 0, 0], file[26..38]);
        Assert.Equal([9, 8, 7, 12, 11, 10, 0, 0, 3, 2, 1, 6, 5, 4, 0, 0], file[54..]);
    }

    [Fact]
    public void Write_with_a_used_encoder_leaves_the_padding_empty()
    {
        var encoder = new BmpEncoder();
        var wide = new PixelBuffer(new ImageSize(5, 1));
        Array.Fill(wide.Bytes, (byte)0xFF);
        var stream = new MemoryStream();
        encoder.Write(wide, stream);
        stream.SetLength(0);
        encoder.Write(new PixelBuffer(new ImageSize(1, 4)), stream);

        Assert.Equal(new byte[16], stream.ToArray()[54..]);
    }

    private static byte[] Encode(PixelBuffer picture)
    {
        var stream = new MemoryStream();
        new BmpEncoder().Write(picture, stream);
        return stream.ToArray();
    }
}
