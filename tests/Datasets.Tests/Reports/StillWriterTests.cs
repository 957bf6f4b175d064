using Harvester.Capture.Imaging;
using Harvester.Capture.Scenes;
using Harvester.Datasets.Images;
using Harvester.Datasets.Reports;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Tests.Reports;

public sealed class StillWriterTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Write_draws_the_sides_of_a_box_in_its_classs_colour_and_leaves_the_rest()
    {
        using (FileStream file = File.Create(_session.PathOf("frames/00000001.png")))
        {
            new PngEncoder().Write(new PixelBuffer(new ImageSize(TestSession.Width, TestSession.Height)), file);
        }

        string path = _session.PathOf("still.png");

        StillWriter.Write(_session.Open(), 1, path);

        // The car's box is [37, 27, 43, 33]: its left side, two pixels wide, covers the columns 36 and 37.
        PixelBuffer still = PngDecoder.ReadRgb(path);
        Assert.Equal(ClassColours.Of(ObjectClass.Car), Colour(still, 36, 30));
        Assert.Equal(ClassColours.Of(ObjectClass.Car), Colour(still, 37, 30));
        Assert.Equal(0, Colour(still, 33, 30));
        Assert.Equal(0, Colour(still, 10, 10));
    }

    [Fact]
    public void Write_of_a_frame_that_is_not_there_says_so() =>
        Assert.Contains(
            "no frame 7",
            Assert.Throws<DatasetFormatException>(() => StillWriter.Write(_session.Open(), 7, _session.PathOf("still.png"))).Message,
            StringComparison.Ordinal);

    private static int Colour(PixelBuffer picture, int column, int row)
    {
        int at = ((row * picture.Size.Width) + column) * PixelBuffer.BytesPerPixel;
        return (picture.Bytes[at] << 16) | (picture.Bytes[at + 1] << 8) | picture.Bytes[at + 2];
    }
}
