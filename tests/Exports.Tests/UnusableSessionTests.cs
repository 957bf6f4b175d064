using Harvester.Exports.Assembly;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>Sessions and plans of which no dataset can be made are refused before anything is written.</summary>
public sealed class UnusableSessionTests : ExportTests
{
    private static readonly SplitPlan LargeBlocks = new([new("train", 0.5), new("val", 0.5)], 1, 100);

    private readonly TestSession _other = new();

    [Fact]
    public void Empty_split_is_refused_with_a_block_that_works()
    {
        string message = Refusal("yolo", [Session.Open()], new ExportOptions { Splits = LargeBlocks });

        Assert.StartsWith(
            "The split 'train' would be empty: 3 frames, assigned in blocks of 100. Use --split-block ",
            message,
            StringComparison.Ordinal
        );
        int block = int.Parse(message.Split(' ')[^4], System.Globalization.CultureInfo.InvariantCulture);
        ExportResult result = Folder.Export(
            "yolo",
            Session.Open(),
            new ExportOptions { Splits = new SplitPlan(LargeBlocks.Splits, LargeBlocks.Seed, block) }
        );
        Assert.All(result.FramesOfSplits.Values, frames => Assert.True(frames > 0));
    }

    [Fact]
    public void Empty_split_of_whole_places_is_refused() =>
        Assert.Equal(
            "The split 'train' would be empty: each place stays in one split, and the sessions have 1 place. "
                + "Add sessions or places, or use fewer splits.",
            Refusal("kitti-tracking", [Session.Open()], new ExportOptions { Splits = LargeBlocks })
        );

    [Fact]
    public void Empty_split_is_refused_with_a_seed_that_works()
    {
        Session.Lines[2]["place"] = 1;
        SplitPlan PlanOf(int seed) => new([new("train", 0.5), new("val", 0.5)], seed);
        int bad = Enumerable.Range(0, 100).First(seed => PlanOf(seed).Of(new(0, 0, 0)) == PlanOf(seed).Of(new(0, 1, 2)));

        string message = Refusal("yolo", [Session.Open()], new ExportOptions { Splits = PlanOf(bad) });

        Assert.Contains("the sessions have 2 places. Use --seed ", message, StringComparison.Ordinal);
        int good = int.Parse(message.Split(' ')[^1].TrimEnd('.'), System.Globalization.CultureInfo.InvariantCulture);
        ExportResult result = Folder.Export("yolo", Session.Open(), new ExportOptions { Splits = PlanOf(good) });
        Assert.Equal([1, 2], result.FramesOfSplits.Values.Order());
    }

    [Fact]
    public void Samples_too_far_apart_for_velocities_are_refused()
    {
        Session.Info["options"] = new System.Text.Json.Nodes.JsonObject { ["rateHz"] = 0.5 };

        Assert.Contains(
            "its session has 0.5 moments a second, and nuscenes needs 0.67 or more",
            Refusal("nuscenes", [Session.Open()]),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Session_without_frames_is_refused() =>
        Assert.Equal($"'{Session.Folder}' has no frames.", Refusal("csv", [Session.OpenWithLabels("")]));

    [Fact]
    public void Shard_of_a_session_is_refused()
    {
        Session.Info["settings"] = new System.Text.Json.Nodes.JsonObject { ["shard"] = "2/8" };

        Assert.Equal(
            $"'{Session.Folder}' is shard 2/8 of a session. Merge the shards first: harvester merge.",
            Refusal("csv", [Session.Open()])
        );
    }

    [Theory]
    [InlineData("coco")]
    [InlineData("webdataset")]
    public void Sessions_with_and_without_masks_are_not_mixed(string format)
    {
        _other.Lines.ForEach(line => line["mask"] = null);

        Assert.Equal(
            $"Labels would not be comparable: '{_other.Folder}' has no masks, and '{Session.Folder}' has. Export sessions with and "
                + $"without masks separately.",
            Refusal(format, [Session.Open(), _other.Open()])
        );
    }

    [Fact]
    public void Session_of_which_some_frames_have_no_mask_is_refused()
    {
        Session.Lines[2]["mask"] = null;

        Assert.Contains($"'{Session.Folder}' has masks for 2 of 3 frames", Refusal("coco", [Session.Open()]), StringComparison.Ordinal);
    }

    [Fact]
    public void Frame_the_format_cannot_represent_is_refused_before_writing()
    {
        _other.Lines[2]["camera"]!["distortion"]!["k1"] = 0.05;

        Assert.Contains(
            "frame 2: its lens bends straight lines",
            Refusal("kitti", [Session.Open(), _other.Open()]),
            StringComparison.Ordinal
        );
    }

    [Theory]
    [InlineData("culane", "train", "train_gt", "In culane, the splits 'train' and 'train_gt' would share the name 'train_gt'.")]
    [InlineData("webdataset", "val_2", "val-2", "In webdataset, the splits 'val_2' and 'val-2' would share the name 'val_2'.")]
    [InlineData("imagefolder", "all", "val", "The Hugging Face hub calls all splits together 'all', so no split in imagefolder can")]
    public void Splits_that_the_format_cannot_keep_apart_are_refused(string format, string first, string second, string message)
    {
        var options = new ExportOptions { Splits = new SplitPlan([new(first, 0.5), new(second, 0.5)], 1, 1) };

        var refusal = Assert.Throws<ArgumentException>(() => Folder.Export(format, Session.Open(), options));

        Assert.StartsWith(message, refusal.Message, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Folder.PathOf("out")));
    }

    protected override void Dispose(bool disposing)
    {
        _other.Dispose();
        base.Dispose(disposing);
    }

    private string Refusal(string format, SessionReader[] sessions, ExportOptions? options = null)
    {
        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() => Folder.Export(format, sessions, options));
        Assert.False(Directory.Exists(Folder.PathOf("out")));
        return refused.Message;
    }
}
