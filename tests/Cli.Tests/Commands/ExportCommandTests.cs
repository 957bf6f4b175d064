using Harvester.Datasets.Exports;

namespace Harvester.Cli.Tests.Commands;

public sealed class ExportCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public ExportCommandTests()
    {
        Directory.CreateDirectory(_folder.PathOf("session"));
        _folder.File("session/session.json", """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 }, "counters": { "captured": 0 } }""");
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("kitti", "export.json")]
    [InlineData("coco", "annotations/instances_train.json")]
    [InlineData("yolo", "data.yaml")]
    [InlineData("csv", "objects.csv")]
    public void Export_writes_a_dataset(string format, string file)
    {
        CliRun run = CliRun.Of("export", _folder.PathOf("session"), "--format", format, "--out", _folder.PathOf("out"));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal($"{_folder.PathOf("out")}: {format}, 0 frames (train 0), 0 of 0 labels written\n", run.Out);
        Assert.True(File.Exists(_folder.PathOf("out/" + file)));
    }

    [Fact]
    public void Summary_says_how_many_frames_were_left_out()
    {
        var result = new ExportResult(DatasetFormats.Find("tusimple")!, 4, IsFinished: true)
        {
            FramesLeftOut = 6,
            FramesOfSplits = new Dictionary<string, int> { ["train"] = 4 },
        };

        Assert.Equal("out: tusimple, 4 frames (train 4); 6 frames without known lanes left out", ExportSummary.Of("out", result));
    }

    [Fact]
    public void Shards_are_merged()
    {
        foreach (string shard in (string[])["1/2", "2/2"])
        {
            CliRun run = CliRun.Of("export", _folder.PathOf("session"), "--format", "csv", "--out", _folder.PathOf("shards"), "--shard", shard);
            Assert.Contains($"shard {shard} of csv", run.Out, StringComparison.Ordinal);
        }

        CliRun merge = CliRun.Of("merge", _folder.PathOf("shards"), "--out", _folder.PathOf("out"));

        Assert.Equal(ExitCode.Done, merge.ExitCode);
        Assert.True(File.Exists(_folder.PathOf("out/export.json")));
    }

    [Theory]
    [InlineData("--format", "pascal", "--format takes one of kitti, ")]
    [InlineData("--split", "train", "--split takes names with shares")]
    [InlineData("--split", "train:0.5,val:0.1", "add up to 1")]
    [InlineData("--classes", "cars", "--classes takes some of car, ")]
    [InlineData("--min-visible", "2", "--min-visible takes a number from 0 to 1")]
    [InlineData("--shard", "3/2", "--shard takes a shard as 1/8")]
    public void Export_with_an_option_that_makes_no_sense_says_what_it_takes(string option, string value, string message)
    {
        string[] format = option == "--format" ? [] : ["--format", "csv"];

        CliRun.Of(["export", _folder.PathOf("session"), "--out", _folder.PathOf("out"), .. format, option, value]).AssertFailed(ExitCode.Usage, message);
    }

    [Theory]
    [InlineData("--segmentation", "polygon", "coco")]
    [InlineData("--classes", "car", "kitti, kitti-tracking, coco, coco-panoptic, yolo, yolo-segment, voc, cityscapes, webdataset, csv")]
    [InlineData("--min-visible", "0.2", "kitti, kitti-tracking, coco, coco-panoptic, yolo, yolo-segment, voc, cityscapes, webdataset, csv")]
    [InlineData("--parts", "none", "coco, yolo, voc, webdataset, csv")]
    [InlineData("--images", "copy", "kitti, kitti-tracking, coco, coco-panoptic, yolo, yolo-segment, voc, cityscapes, tusimple, openlane, csv")]
    [InlineData("--split-block", "10", "kitti, coco, coco-panoptic, yolo, yolo-segment, voc, cityscapes, deepdriving, tusimple, openlane, webdataset, csv")]
    public void Export_takes_an_option_with_the_formats_only_in_which_it_does_something(string option, string value, string formats)
    {
        foreach (string format in DatasetFormats.All.Select(format => format.Name))
        {
            CliRun run = CliRun.Of("export", _folder.PathOf("session"), "--out", _folder.PathOf(format), "--format", format, option, value);
            if (formats.Split(", ").Contains(format))
            {
                Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
            }
            else
            {
                run.AssertFailed(ExitCode.Usage, $"{option} does nothing in {format}. It is for {formats}.");
                Assert.False(Directory.Exists(_folder.PathOf(format)));
            }
        }
    }

    [Fact]
    public void Export_of_a_session_that_is_named_twice_is_refused()
    {
        CliRun.Of("export", _folder.PathOf("session"), _folder.PathOf("session/"), "--format", "csv", "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.Usage, $"'{_folder.PathOf("session")}' is named twice");

        Assert.False(Directory.Exists(_folder.PathOf("out")));
    }

    [Theory]
    [InlineData("export", "session", "--format", "csv")]
    [InlineData("merge", "shards")]
    [InlineData("harvest")]
    [InlineData("drive")]
    public void Folder_for_output_that_holds_something_else_is_a_usage_error(params string[] command)
    {
        foreach (string shard in (string[])["1/2", "2/2"])
        {
            CliRun.Of("export", _folder.PathOf("session"), "--format", "csv", "--out", _folder.PathOf("shards"), "--shard", shard);
        }

        string[] words = [.. command.Select(word => word is "session" or "shards" ? _folder.PathOf(word) : word)];

        CliRun run = CliRun.Of([.. words, "--out", _folder.PathOf("session")]);

        run.AssertFailed(ExitCode.Usage, _folder.PathOf("session"));
        Assert.Contains("Name another folder", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Export_of_a_malformed_line_names_the_session_that_it_is_in()
    {
        Directory.CreateDirectory(_folder.PathOf("other"));
        File.Copy(_folder.PathOf("session/session.json"), _folder.PathOf("other/session.json"));
        _folder.File("other/labels.jsonl", "{}\n");

        CliRun.Of("export", _folder.PathOf("session"), _folder.PathOf("other"), "--format", "csv", "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.BadData, $"{_folder.PathOf("other/labels.jsonl")}, line 1: frame is missing.");
    }

    [Fact]
    public void Export_of_no_session_is_an_input_error() =>
        CliRun.Of("export", "no-such-session", "--format", "csv", "--out", _folder.PathOf("out")).AssertFailed(ExitCode.InputOutput, "no-such-session");

    [Fact]
    public void Merge_of_a_finished_dataset_says_that_it_is_whole()
    {
        CliRun.Of("export", _folder.PathOf("session"), "--format", "csv", "--out", _folder.PathOf("whole"));

        CliRun.Of("merge", _folder.PathOf("whole"), "--out", _folder.PathOf("out")).AssertFailed(ExitCode.BadData, "is a whole dataset, no shard of one.");
    }

    [Fact]
    public void Merge_of_a_folder_without_shards_is_an_error_of_the_data() =>
        CliRun.Of("merge", _folder.PathOf("session"), "--out", _folder.PathOf("out")).AssertFailed(ExitCode.BadData, "is a whole session, no shard of one");
}
