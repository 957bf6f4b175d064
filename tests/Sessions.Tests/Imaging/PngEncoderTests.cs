using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.TestSupport;

namespace Harvester.Sessions.Tests.Imaging;

public sealed class PngEncoderTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(7, 5)]
    [InlineData(800, 600)]
    [InlineData(3, 2001)]
    public void Write_colour_is_read_back(int width, int height)
    {
        var picture = new PixelBuffer(new ImageSize(width, height));
        new Random(1).NextBytes(picture.Bytes);

        TestPngDecoder decoded = Encode(new PngEncoder(), picture);

        Assert.Equal((width, height, 8, 2), (decoded.Width, decoded.Height, decoded.Bits, decoded.ColourType));
        Assert.Equal(picture.Bytes, decoded.Samples);
    }

    [Fact]
    public void Write_instance_map_is_read_back_with_the_high_byte_first()
    {
        var map = new InstanceMap(new ImageSize(3, 2))
        {
            [0, 0] = 1,
            [2, 0] = 0x1234,
            [1, 1] = 65_535,
        };

        var stream = new MemoryStream();
        new PngEncoder().Write(map, stream);
        TestPngDecoder decoded = TestPngDecoder.Decode(stream.ToArray());

        Assert.Equal((3, 2, 16, 0), (decoded.Width, decoded.Height, decoded.Bits, decoded.ColourType));
        Assert.Equal([0, 1, 0, 0, 0x12, 0x34, 0, 0, 0xFF, 0xFF, 0, 0], decoded.Samples);
    }

    [Fact]
    public void Write_with_a_used_encoder_gives_what_a_new_one_gives()
    {
        var used = new PngEncoder();
        var large = new PixelBuffer(new ImageSize(64, 64));
        new Random(2).NextBytes(large.Bytes);
        var small = new PixelBuffer(new ImageSize(8, 8));
        new Random(3).NextBytes(small.Bytes);
        Encode(used, large);

        Assert.Equal(small.Bytes, Encode(used, small).Samples);
        Assert.Equal(Bytes(new PngEncoder(), small), Bytes(used, small));
    }

    [Fact]
    public void Write_of_a_long_run_of_maximal_bytes_has_a_valid_checksum()
    {
        // 0xFF in the first row only: Up turns the others to 0; a wide row makes Adler-32's sums grow fastest.
        var picture = new PixelBuffer(new ImageSize(30_000, 2));
        Array.Fill(picture.Bytes, (byte)0xFF);

        Assert.Equal(picture.Bytes, Encode(new PngEncoder(), picture).Samples);
    }

    private static TestPngDecoder Encode(PngEncoder encoder, PixelBuffer picture) => TestPngDecoder.Decode(Bytes(encoder, picture));

    private static byte[] Bytes(PngEncoder encoder, PixelBuffer picture)
    {
        var stream = new MemoryStream();
        encoder.Write(picture, stream);
        return stream.ToArray();
    }
}
