using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Sessions.Tests.Reading.Images;

public sealed class PictureReaderTests : IDisposable
{
    private readonly string _path = Path.GetTempFileName();

    public void Dispose() => File.Delete(_path);

    [Theory]
    [InlineData(ImageFormat.Png)]
    [InlineData(ImageFormat.Bmp)]
    public void Read_gives_back_the_pixels_of_a_format_without_loss(ImageFormat format)
    {
        PixelBuffer picture = Write(format);

        PixelBuffer read = PictureReader.Read(_path);

        Assert.Equal(picture.Size, read.Size);
        Assert.Equal(picture.Bytes, read.Bytes);
    }

    [Fact]
    public void Read_of_a_jpeg_gives_nearly_the_same_pixels()
    {
        PixelBuffer picture = Write(ImageFormat.Jpeg);

        PixelBuffer read = PictureReader.Read(_path);

        // A slope of brightness is compressed nearly without loss: rounding to YCbCr and back costs 2 at most, quantisation at 95 about as
        // much.
        Assert.All(picture.Bytes.Zip(read.Bytes), pair => Assert.InRange(pair.Second - pair.First, -5, 5));
    }

    [Fact]
    public void Read_reports_a_bmp_without_its_last_row()
    {
        Write(ImageFormat.Bmp);
        byte[] file = File.ReadAllBytes(_path)[..^100];
        BitConverter.GetBytes(file.Length).CopyTo(file, 2);
        File.WriteAllBytes(_path, file);

        Assert.Contains(
            "cut off",
            Assert.Throws<DatasetFormatException>(() => PictureReader.Read(_path)).Message,
            StringComparison.Ordinal
        );
    }

    private PixelBuffer Write(ImageFormat format)
    {
        var picture = new PixelBuffer(new ImageSize(37, 23));
        for (int i = 0; i < picture.Bytes.Length; i++)
        {
            picture.Bytes[i] = (byte)(i / PixelBuffer.BytesPerPixel % 37 * 6);
        }

        using FileStream file = File.Create(_path);
        new PictureEncoder(format).Write(picture, file);
        return picture;
    }
}
