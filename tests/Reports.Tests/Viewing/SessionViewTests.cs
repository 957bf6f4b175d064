using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Reports.Viewing;
using Harvester.Sessions.Reading.Files;
using Harvester.TestSupport;

namespace Harvester.Reports.Tests.Viewing;

public sealed class SessionViewTests : IDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(30);

    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Frame_has_its_label_objects_and_rasters()
    {
        using var view = new SessionView(_session.Open());

        JsonNode answer = JsonNode.Parse(view.Frame(1))!;

        Assert.Equal(1, (int)answer["frame"]!["frame"]!);
        Assert.Equal([37.0, 27, 43, 33], answer["frame"]!["objects"]![0]!["box"]!.AsArray().Select(side => (double)side!));
        Assert.Equal("car", (string)answer["objects"]!["1"]!["class"]!);
        Assert.Equal(["image", "mask"], answer["rasters"]!.AsArray().Select(name => (string)name!));
    }

    [Fact]
    public void Files_of_a_frame_are_those_of_the_session()
    {
        using var view = new SessionView(_session.Open());

        Assert.Equal(("image/png", File.ReadAllBytes(_session.PathOf("frames/00000002.png"))), view.Raster(2, FrameRaster.Image));
        Assert.Equal(("image/png", File.ReadAllBytes(_session.PathOf("masks/00000002.png"))), view.Raster(2, FrameRaster.Mask));
        Assert.Null(view.Raster(2, FrameRaster.Depth));
    }

    [Fact]
    public void Frame_number_is_found_despite_gaps()
    {
        _session.Lines[1]["frame"] = 5;
        _session.Lines[2]["frame"] = 9;
        using var view = new SessionView(_session.Open());

        int[] asked = [0, 1, 5, 6, 9, 10]; // Of frames 0, 5 and 9.
        Assert.Equal([0, 1, 1, 2, 2, 3], asked.Select(view.IndexOf));
    }

    [Fact]
    public void Damaged_line_is_counted_and_named()
    {
        _session.Lines[1].Remove("camera");
        using var view = new SessionView(_session.Open());
        AwaitFrames(view, 3);

        JsonNode state = JsonNode.Parse(view.State())!;
        Assert.Equal(1, (int)state["problems"]!);
        Assert.Contains("labels.jsonl, line 2: ", (string)state["problem"]!, StringComparison.Ordinal);
        Assert.Throws<DatasetFormatException>(() => view.Frame(1));
        Assert.NotEmpty(view.Frame(2));
    }

    [Fact]
    public void Frame_that_does_not_exist_is_refused()
    {
        using var view = new SessionView(_session.Open());

        Assert.Throws<ArgumentOutOfRangeException>(() => view.Frame(3));
        Assert.Null(view.Block(1));
    }

    [Fact]
    public void Mask_outside_the_session_is_not_read()
    {
        _session.Lines[0]["mask"] = "../mask.png";
        using var view = new SessionView(_session.Open());

        Assert.Throws<DatasetFormatException>(() => view.Raster(0, FrameRaster.Mask));
    }

    [Fact]
    public void Statistics_cover_all_frames()
    {
        using var view = new SessionView(_session.Open());
        AwaitFrames(view, 3);

        JsonNode figures = JsonNode.Parse(view.Figures())!;

        Assert.Equal("6", (string)figures["facts"]!["Labels"]!);
        Assert.Equal(3, (int)figures["classes"]!["car"]!["labels"]!);
    }

    private static void AwaitFrames(SessionView view, int frames) =>
        Assert.True(
            SpinWait.SpinUntil(() => JsonSerializer.Deserialize<JsonNode>(view.State())!["read"]!.GetValue<int>() == frames, Patience)
        );
}
