using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.TestSupport;

namespace Harvester.Sessions.Tests.Imaging;

public sealed class JpegEncoderTests
{
    [Theory]
    [InlineData(50)]
    [InlineData(95)]
    [InlineData(100)]
    public void Write_gives_the_bytes_of_libjpeg(int quality)
    {
        byte[] expected = File.ReadAllBytes(LibjpegPictures.PathOf($"quality-{quality}.jpg"));

        Assert.Equal(expected, Bytes(new JpegEncoder(quality), LibjpegPictures.Pattern));
    }

    [Theory]
    [InlineData(1, 1, 95)]
    [InlineData(8, 8, 1)]
    [InlineData(63, 17, 30)]
    [InlineData(320, 240, 100)]
    public void Vectors_and_single_integers_give_the_same_bytes(int width, int height, int quality)
    {
        PixelBuffer picture = Noise(width, height, seed: width);

        Assert.Equal(
            Bytes(new JpegEncoder(quality, (luma, chroma) => new PortableBlockTransform(luma, chroma)), picture),
            Bytes(new JpegEncoder(quality), picture)
        );
    }

    [Fact]
    public void Extreme_pixels_are_coded_at_every_quality()
    {
        // Blocks of 0 and 255 alone have the greatest coefficients that there are.
        var picture = new PixelBuffer(new ImageSize(64, 64));
        var random = new Random(4);
        for (int i = 0; i < picture.Bytes.Length; i++)
        {
            picture.Bytes[i] = random.Next(2) == 0 ? (byte)0 : (byte)255;
        }

        for (int quality = JpegEncoder.MinQuality; quality <= JpegEncoder.MaxQuality; quality++)
        {
            byte[] file = Bytes(new JpegEncoder(quality), picture);
            Assert.Equal([0xFF, 0xD9], file[^2..]);
        }
    }

    [Fact]
    public void Reused_encoder_writes_the_same_bytes_as_a_new_one()
    {
        var used = new JpegEncoder();
        _ = Bytes(used, Noise(200, 100, seed: 2));
        PixelBuffer picture = Noise(33, 20, seed: 3);

        Assert.Equal(Bytes(new JpegEncoder(), picture), Bytes(used, picture));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(101)]
    public void Quality_out_of_range_is_refused(int quality) => Assert.Throws<ArgumentOutOfRangeException>(() => new JpegEncoder(quality));

    private static PixelBuffer Noise(int width, int height, int seed)
    {
        var picture = new PixelBuffer(new ImageSize(width, height));
        new Random(seed).NextBytes(picture.Bytes);
        return picture;
    }

    private static byte[] Bytes(JpegEncoder encoder, PixelBuffer picture)
    {
        using var stream = new MemoryStream();
        encoder.Write(picture, stream);
        return stream.ToArray();
    }
}
