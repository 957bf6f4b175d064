using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Sessions.Tests.Reading.Images;

public sealed class ImageHeaderTests : IDisposable
{
    private readonly string _path = Path.GetTempFileName();

    public void Dispose() => File.Delete(_path);

    [Theory]
    [InlineData(8, 2, 24)]
    [InlineData(16, 0, 16)]
    [InlineData(8, 6, 32)]
    public void Read_of_a_png_gives_size_and_depth(byte bitDepth, byte colourType, int bitsPerPixel)
    {
        File.WriteAllBytes(_path, TestImages.Png(800, 600, bitDepth, colourType));

        Assert.Equal(new ImageHeader("image/png", new ImageSize(800, 600), bitsPerPixel), ImageHeader.Read(_path));
    }

    [Theory]
    [InlineData(600)]
    [InlineData(-600)]
    public void Read_of_a_bmp_gives_size_and_depth_for_either_row_order(int height)
    {
        File.WriteAllBytes(_path, TestImages.Bmp(800, height));

        Assert.Equal(new ImageHeader("image/bmp", new ImageSize(800, 600), 24), ImageHeader.Read(_path));
    }

    [Fact]
    public void Read_reports_a_truncated_bmp()
    {
        File.WriteAllBytes(_path, TestImages.Bmp(800, 600)[..50]);

        // 54 bytes of header, and 600 rows of 800 * 3.
        Assert.Contains(
            "50 of 1440054 bytes",
            Assert.Throws<DatasetFormatException>(() => ImageHeader.Read(_path)).Message,
            StringComparison.Ordinal
        );
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData(70000)]
    public void Read_reports_an_impossible_size(int width)
    {
        File.WriteAllBytes(_path, TestImages.PngWithoutPixels(width, 600));

        Assert.Contains(
            "impossible size",
            Assert.Throws<DatasetFormatException>(() => ImageHeader.Read(_path)).Message,
            StringComparison.Ordinal
        );
    }

    [Theory]
    [InlineData(0)]
    [InlineData(8)]
    [InlineData(32)]
    public void Read_reports_a_file_of_a_few_bytes(int length)
    {
        File.WriteAllBytes(_path, TestImages.Png(800, 600)[..length]);

        Assert.Throws<DatasetFormatException>(() => ImageHeader.Read(_path));
    }
}
