using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Reading.Images.Jpeg;
using Harvester.TestSupport;

namespace Harvester.Sessions.Tests.Reading.Images;

public sealed class JpegDecoderTests : IDisposable
{
    private readonly string _path = Path.GetTempFileName();

    public void Dispose() => File.Delete(_path);

    [Theory]
    [InlineData("quality-50")]
    [InlineData("quality-95")]
    [InlineData("quality-100")]
    [InlineData("optimised")]
    [InlineData("grey")]
    [InlineData("restarts")]
    public void ReadRgb_gives_the_pixels_that_libjpeg_gives(string name)
    {
        PixelBuffer expected = PngDecoder.ReadRgb(LibjpegPictures.PathOf(name + ".png"));

        PixelBuffer read = JpegDecoder.ReadRgb(LibjpegPictures.PathOf(name + ".jpg"));

        Assert.Equal(expected.Size, read.Size);
        Assert.Equal(expected.Bytes, read.Bytes);
    }

    [Fact]
    public void ReadRgb_of_subsampled_jpeg_equals_libjpeg_except_at_edges()
    {
        // libjpeg interpolates between the samples of colour, of which each stands for two pixels: only the two at a border differ.
        const int tile = 16;
        const int interpolated = 1;
        PixelBuffer expected = PngDecoder.ReadRgb(LibjpegPictures.PathOf("subsampled.png"));

        PixelBuffer read = JpegDecoder.ReadRgb(LibjpegPictures.PathOf("subsampled.jpg"));

        for (int i = 0; i < read.Bytes.Length; i++)
        {
            int x = i / PixelBuffer.BytesPerPixel % read.Size.Width;
            int y = i / PixelBuffer.BytesPerPixel / read.Size.Width;
            bool isAtBorder = Math.Abs(x + 0.5 - tile) < interpolated || Math.Abs(y + 0.5 - tile) < interpolated;
            Assert.True(isAtBorder || read.Bytes[i] == expected.Bytes[i], $"({x}, {y}): {read.Bytes[i]} instead of {expected.Bytes[i]}");
        }
    }

    [Theory]
    [InlineData("progressive", "a progressive JPEG")]
    [InlineData("cmyk", "a JPEG of 4 components")]
    public void ReadRgb_reports_the_kind_of_an_unsupported_jpeg(string name, string kind)
    {
        string message = Assert.Throws<DatasetFormatException>(() => JpegDecoder.ReadRgb(LibjpegPictures.PathOf(name + ".jpg"))).Message;

        Assert.Contains($"it is {kind}. Only baseline JPEG", message, StringComparison.Ordinal);
    }

    [Fact]
    public void ReadRgb_of_an_Adobe_RGB_picture_is_refused()
    {
        byte[] file = File.ReadAllBytes(LibjpegPictures.PathOf("quality-95.jpg"));
        byte[] adobe = [0xFF, 0xEE, 0, 14, (byte)'A', (byte)'d', (byte)'o', (byte)'b', (byte)'e', 0, 100, 0, 0, 0, 0, 0];
        File.WriteAllBytes(_path, [.. file[..2], .. adobe, .. file[2..]]);

        Assert.Contains(
            "not in YCbCr",
            Assert.Throws<DatasetFormatException>(() => JpegDecoder.ReadRgb(_path)).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void ReadRgb_reports_missing_pixels()
    {
        byte[] file = File.ReadAllBytes(LibjpegPictures.PathOf("quality-95.jpg"));
        File.WriteAllBytes(_path, [.. file[..^40], 0xFF, 0xD9]);

        Assert.Contains(
            "cut off",
            Assert.Throws<DatasetFormatException>(() => JpegDecoder.ReadRgb(_path)).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void ReadRgb_of_damaged_bytes_gives_a_picture_or_an_error()
    {
        byte[] good = File.ReadAllBytes(LibjpegPictures.PathOf("restarts.jpg"));
        byte[] values = [.. Enumerable.Range(0, 256).Select(value => (byte)value)];
        int refused = 0;
        RandomCases.Check(
            400,
            ByteChange.Lists(count: 3, maxLength: 20, values),
            changes =>
            {
                File.WriteAllBytes(_path, ByteChange.Apply(changes, good));
                refused += Record.Exception(() => JpegDecoder.ReadRgb(_path)) switch
                {
                    null => 0,
                    DatasetFormatException => 1,
                    Exception other => throw other,
                };
            }
        );

        Assert.InRange(refused, 1, 400);
    }

    [Fact]
    public void ImageHeader_of_a_jpeg_gives_size_and_depth() =>
        Assert.Equal(new ImageHeader("image/jpeg", new ImageSize(45, 29), 24), ImageHeader.Read(LibjpegPictures.PathOf("quality-95.jpg")));

    [Fact]
    public void ImageHeader_reports_a_truncated_jpeg()
    {
        File.WriteAllBytes(_path, File.ReadAllBytes(LibjpegPictures.PathOf("quality-95.jpg"))[..^3]);

        Assert.Contains("cut off", Assert.Throws<DatasetFormatException>(() => ImageHeader.Read(_path)).Message, StringComparison.Ordinal);
    }
}
