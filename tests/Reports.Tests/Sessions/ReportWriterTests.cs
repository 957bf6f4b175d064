using System.Text.Json;
using System.Text.RegularExpressions;
using Harvester.Geometry.Cameras;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Reports.Tests.Sessions;

public sealed partial class ReportWriterTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Page_has_all_frames_with_boxes_and_images()
    {
        string page = Write(new ReportLimits());

        JsonElement data = Data(page);
        Assert.Equal([0, 1, 2], Frames(data));
        JsonElement car = data.GetProperty("frames")[0].GetProperty("objects")[0];
        Assert.Equal("car", Object(data, car).GetProperty("class").GetString());
        Assert.Equal([37.0, 27, 43, 33], car.GetProperty("box").EnumerateArray().Select(side => side.GetDouble()));
        Assert.Equal(16, car.GetProperty("corners").GetArrayLength());
        Assert.Equal(3, Images(page).Count);
        Assert.Equal("This page shows all 3 frames of the session.", data.GetProperty("note").GetString());
    }

    [Fact]
    public void Image_that_cannot_be_decoded_is_embedded_unchanged()
    {
        byte[] undecodable = LeaveFramesWithoutPixels();

        Assert.All(Images(Write(new ReportLimits())), image => Assert.Equal(undecodable, image));
    }

    [Fact]
    public void Images_are_embedded_as_JPEG_of_full_size()
    {
        PaintFrames();

        Assert.All(
            Images(Write(new ReportLimits())),
            image => Assert.Equal((ImageHeader.Jpeg, new ImageSize(TestSession.Width, TestSession.Height)), Header(image))
        );
    }

    [Fact]
    public void JPEG_image_of_full_size_is_embedded_unchanged()
    {
        PaintFrames();
        byte[] jpeg;
        using (var file = new MemoryStream())
        {
            new JpegEncoder().Write(PictureReader.Read(_session.PathOf("frames/00000001.png")), file);
            jpeg = file.ToArray();
        }

        File.WriteAllBytes(_session.PathOf("frames/00000001.png"), jpeg);

        Assert.Equal(jpeg, Images(Write(new ReportLimits()))[1]);
    }

    [Fact]
    public void Image_bytes_beyond_the_limit_shrink_the_images()
    {
        PaintFrames();
        long whole = Images(Write(new ReportLimits())).Sum(image => (long)image.Length);

        string page = Write(new ReportLimits(ImageBytes: whole / 2));

        Assert.Equal([0, 1, 2], Frames(Data(page)));
        Assert.InRange(Images(page).Sum(image => (long)image.Length), 1, whole / 2);
        Assert.All(Images(page), image => Assert.InRange(Header(image).Size.Width, TestSession.Width / 8, TestSession.Width - 1));
        Assert.Contains(" % so that the page stays small.", Data(page).GetProperty("note").GetString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Object_cut_by_the_near_plane_has_edges()
    {
        // The camera looks along the y axis; the car's box then reaches from behind it to 12 m ahead.
        _session.Car(0)["box3d"]!["halfExtents"]![1] = 12;

        JsonElement car = Data(Write(new ReportLimits())).GetProperty("frames")[0].GetProperty("objects")[0];

        Assert.False(car.TryGetProperty("corners", out _));
        Assert.InRange(car.GetProperty("edges").GetArrayLength(), 4, 12);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Posts_are_marked_and_drawn_if_asked_for(bool showsPosts)
    {
        _session.Car(1)["class"] = "sign";
        _session.Pedestrian(1)["class"] = "sign";
        _session.Pedestrian(1)["parent"] = 1;

        JsonElement data = Data(Write(new ReportLimits { ShowsPosts = showsPosts }));

        Assert.Equal(showsPosts, data.GetProperty("posts").GetBoolean());
        Assert.Equal(
            [
                [false, false],
                [true, false],
                [false, false],
            ],
            data.GetProperty("frames")
                .EnumerateArray()
                .Select(frame => frame.GetProperty("objects").EnumerateArray().Select(item => item.TryGetProperty("post", out _)))
        );
    }

    [Fact]
    public void Page_has_the_statistics_beside_those_of_KITTI()
    {
        JsonElement data = Data(Write(new ReportLimits()));

        // Three frames with two labels each; 80,256 labels in 7,481 + 7,518 = 14,999 images are 5.35 each.
        Assert.Equal(
            [
                "Images|3|14,999",
                "Images for training||7,481",
                "Images for testing||7,518",
                "Labels (no signs or traffic lights)|6|80,256",
                "Labels per image|2.0|5.4",
            ],
            data.GetProperty("comparison").GetProperty("rows").EnumerateArray().Select(row => string.Join('|', row.EnumerateArray()))
        );
        Assert.Equal(
            ["distance", "box height", "box width", "box area", "truncation", "occlusion"],
            data.GetProperty("histograms").EnumerateArray().Select(chart => chart.GetProperty("title").GetString()!["Labels by ".Length..])
        );
        // The car's box is 6 x 6 pixels, the pedestrian's 10 x 12: 36 and 120 square pixels, in the bins from 0 and from 64 on.
        JsonElement areas = data.GetProperty("histograms")[3];
        Assert.Equal([0, 64, 256], areas.GetProperty("starts").EnumerateArray().Take(3).Select(start => start.GetInt32()));
        Assert.Equal([3, 3, 0], areas.GetProperty("counts").EnumerateArray().Take(3).Select(count => count.GetInt32()));
        Assert.Equal(3, data.GetProperty("weathers").GetProperty("clear").GetInt32());
        Assert.Equal(3, data.GetProperty("hours").GetProperty("13:00").GetInt32());
        Assert.Empty(data.GetProperty("indicators").EnumerateObject());
    }

    [Fact]
    public void Page_refers_to_no_other_file()
    {
        string page = Write(new ReportLimits());

        // The one address in the page is the name of the SVG namespace, which is never fetched.
        Assert.Equal(["http://www.w3.org/2000/svg"], Address().Matches(page).Select(match => match.Value).Distinct());
        Assert.DoesNotContain("src=\"", page, StringComparison.Ordinal);
        Assert.DoesNotContain("<link", page, StringComparison.Ordinal);
    }

    [Fact]
    public void Frames_beyond_the_limit_are_thinned_out_evenly()
    {
        JsonElement data = Data(Write(new ReportLimits(Frames: 2)));

        Assert.Equal([0, 2], Frames(data));
        Assert.Contains("2 of the session's 3 frames", data.GetProperty("note").GetString(), StringComparison.Ordinal);
        Assert.Equal("3", data.GetProperty("facts").GetProperty("Frames").GetString());
    }

    [Fact]
    public void Image_bytes_beyond_the_limit_leave_fewer_frames()
    {
        // What cannot be decoded is not scaled down either.
        long imageBytes = LeaveFramesWithoutPixels().Length;

        Assert.Equal([0, 2], Frames(Data(Write(new ReportLimits(ImageBytes: 2 * imageBytes)))));
        Assert.Equal([0], Frames(Data(Write(new ReportLimits(ImageBytes: 1)))));
    }

    [Fact]
    public void Linked_images_are_named_relative_to_the_page()
    {
        string page = Path.Combine(Directory.CreateDirectory(_session.PathOf("my pages")).FullName, "page.html");

        int shown = new ReportWriter(_session.Open(), new ReportLimits(ImageBytes: 1) { LinksImages = true }).Write(page);

        string html = File.ReadAllText(page);
        Assert.Equal(3, shown);
        Assert.Contains("id=\"image-2\" data-href=\"../frames/00000002.png\"></script>", html, StringComparison.Ordinal);
        Assert.DoesNotContain("data-type", html.Split("<script>")[0], StringComparison.Ordinal);
    }

    [Fact]
    public void Name_with_markup_cannot_end_the_data()
    {
        _session.Car(0)["name"] = "</script><b>";

        JsonElement data = Data(Write(new ReportLimits()));

        Assert.Equal("</script><b>", Object(data, data.GetProperty("frames")[0].GetProperty("objects")[0]).GetProperty("name").GetString());
    }

    [Fact]
    public void Empty_session_gives_a_page_without_frames()
    {
        _session.Lines.Clear();

        Assert.Empty(Frames(Data(Write(new ReportLimits()))));
    }

    [Fact]
    public void Invalid_camera_is_reported()
    {
        _session.Lines[1]["camera"]!["nearClip"] = -1;

        Assert.Contains(
            "camera: nearClip",
            Assert.Throws<DatasetFormatException>(() => Write(new ReportLimits())).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Failure_keeps_the_older_report()
    {
        Write(new ReportLimits());
        string report = _session.PathOf("report.html");
        byte[] before = File.ReadAllBytes(report);
        File.Delete(_session.PathOf("frames/00000001.png"));

        Assert.Throws<FileNotFoundException>(() => new ReportWriter(_session.Open()).Write(report));

        Assert.Equal(before, File.ReadAllBytes(report));
        Assert.Empty(Directory.GetFiles(_session.PathOf(""), "*.partial"));
    }

    private static JsonElement Object(JsonElement data, JsonElement seen) =>
        data.GetProperty("objects").GetProperty(seen.GetProperty("id").GetRawText());

    private (string MediaType, ImageSize Size) Header(byte[] image)
    {
        string path = _session.PathOf("embedded");
        File.WriteAllBytes(path, image);
        ImageHeader header = ImageHeader.Read(path);
        return (header.MediaType, header.Size);
    }

    /// <summary>Gives the frames pictures that can be decoded: noise, which takes many bytes.</summary>
    private void PaintFrames()
    {
        var random = new Random(1);
        var picture = new PixelBuffer(new ImageSize(TestSession.Width, TestSession.Height));
        foreach (string path in Directory.GetFiles(_session.PathOf("frames")))
        {
            random.NextBytes(picture.Bytes);
            using FileStream file = File.Create(path);
            new PngEncoder().Write(picture, file);
        }
    }

    private byte[] LeaveFramesWithoutPixels()
    {
        byte[] png = TestImages.PngWithoutPixels(TestSession.Width, TestSession.Height);
        foreach (string path in Directory.GetFiles(_session.PathOf("frames")))
        {
            File.WriteAllBytes(path, png);
        }

        return png;
    }

    private string Write(ReportLimits limits)
    {
        string path = _session.PathOf("report.html");
        int shown = new ReportWriter(_session.Open(), limits).Write(path);
        string page = File.ReadAllText(path);
        Assert.Equal(shown, Images(page).Count);
        return page;
    }

    private static IEnumerable<int> Frames(JsonElement data) =>
        data.GetProperty("frames").EnumerateArray().Select(frame => frame.GetProperty("frame").GetInt32());

    private static JsonElement Data(string page) => JsonDocument.Parse(DataElement().Match(page).Groups[1].Value).RootElement;

    private static List<byte[]> Images(string page) =>
        [.. ImageElement().Matches(page).Select(match => Convert.FromBase64String(match.Groups[1].Value))];

    [GeneratedRegex("""id="data">\s*(.*?)</script>""", RegexOptions.Singleline)]
    private static partial Regex DataElement();

    [GeneratedRegex("""data-type="image/(?:png|jpeg)">(.*?)</script>""")]
    private static partial Regex ImageElement();

    [GeneratedRegex("""https?://[^"' ]*""")]
    private static partial Regex Address();
}
