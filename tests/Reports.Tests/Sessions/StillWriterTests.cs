using Harvester.Datasets.Colours;
using Harvester.Geometry.Cameras;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Reports.Tests.Sessions;

public sealed class StillWriterTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Write_draws_box_edges_in_the_class_colour_and_nothing_else()
    {
        DrawOnBlack(1);
        _session.Car(1)["occludedFraction"] = 0.0;
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
    public void Write_draws_a_hidden_object_fainter()
    {
        DrawOnBlack(1);
        _session.Car(1)["occludedFraction"] = 1.0;
        string path = _session.PathOf("still.png");

        StillWriter.Write(_session.Open(), 1, path);

        // All is drawn with 0.3 of its opacity, over black. Blue, 255: the 3D edge covers half of the pixel at 0.6, 0.5 * 0.6 * 0.3 * 255 =
        // 23; the dark outline takes 0.45 * 0.3 of that, 20 are left; the box adds 0.3 * (255 - 20), which makes 90.5.
        Assert.InRange(Colour(PngDecoder.ReadRgb(path), 36, 30) & 0xFF, 90, 92);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Write_draws_posts_only_if_asked_for(bool showsPosts)
    {
        DrawOnBlack(1);
        _session.Car(1)["class"] = "sign";
        _session.Pedestrian(1)["class"] = "sign";
        _session.Pedestrian(1)["parent"] = 1;
        string path = _session.PathOf("still.png");

        StillWriter.Write(_session.Open(), 1, path, showsPosts);

        PixelBuffer still = PngDecoder.ReadRgb(path);
        Assert.Equal(showsPosts, Colour(still, 36, 30) != 0);
        Assert.NotEqual(0, Colour(still, 70, 30));
    }

    [Fact]
    public void Write_reports_a_missing_frame() =>
        Assert.Contains(
            "no frame 7",
            Assert.Throws<DatasetFormatException>(() => StillWriter.Write(_session.Open(), 7, _session.PathOf("still.png"))).Message,
            StringComparison.Ordinal
        );

    private void DrawOnBlack(int frame)
    {
        using FileStream file = File.Create(_session.PathOf($"frames/{frame:D8}.png"));
        new PngEncoder().Write(new PixelBuffer(new ImageSize(TestSession.Width, TestSession.Height)), file);
    }

    private static int Colour(PixelBuffer picture, int column, int row)
    {
        int at = ((row * picture.Size.Width) + column) * PixelBuffer.BytesPerPixel;
        return (picture.Bytes[at] << 16) | (picture.Bytes[at + 1] << 8) | picture.Bytes[at + 2];
    }
}
