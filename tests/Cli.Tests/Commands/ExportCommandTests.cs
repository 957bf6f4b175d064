using System.Text.RegularExpressions;
using Harvester.Cli.Terminals;
using Harvester.Exports.Assembly;
using Harvester.Exports.Formats;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Tests.Commands;

public sealed class ExportCommandTests(SmallSession session) : IClassFixture<SmallSession>, IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("kitti", "export.json")]
    [InlineData("coco", "annotations/instances_train.json")]
    [InlineData("yolo", "data.yaml")]
    [InlineData("csv", "objects.csv")]
    [InlineData("parquet", "objects.parquet")]
    public void Export_writes_a_dataset(string format, string file)
    {
        CliRun run = CliRun.Of("export", session.Folder, "--format", format, "--out", _folder.PathOf("out"));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Matches(
            $"^{Regex.Escape(_folder.PathOf("out"))}: {format}, 2 frames \\(train 2\\), "
                + "[0-9]+ of [0-9]+ labels written(, [0-9]+ regions? marked as ignored)?"
                + "(; [0-9]+ of [0-9]+ labels (not written|written as poles): posts)?\n$",
            run.Out
        );
        Assert.True(File.Exists(_folder.PathOf("out/" + file)));
    }

    [Theory]
    [InlineData("kitti", "bus=Bus", "--map: kitti has no class 'Bus'. Its classes are Car, Van, Truck,")]
    [InlineData("cityscapes", "bus=Bus", "--map: cityscapes has no class 'Bus'. Its classes are unlabeled, ")]
    [InlineData("kitti", "bus=DontCare", "--map: kitti has no class 'DontCare'.")]
    public void Class_name_unknown_to_the_format_is_refused(string format, string map, string message) =>
        CliRun
            .Of("export", session.Folder, "--format", format, "--out", _folder.PathOf("out"), "--map", map)
            .AssertFailed(ExitCode.Usage, message);

    [Theory]
    [InlineData("kitti", "other=Misc")]
    [InlineData("kitti-tracking", "other=Misc")]
    [InlineData("coco", "car=auto")]
    [InlineData("coco-panoptic", "car=auto")]
    [InlineData("yolo", "car=auto")]
    [InlineData("yolo-segment", "car=auto")]
    [InlineData("voc", "car=auto")]
    [InlineData("cityscapes", "other=static")]
    [InlineData("csv", "car=auto")]
    [InlineData("parquet", "car=auto")]
    [InlineData("bdd100k", "other=train")]
    [InlineData("openlabel", "car=auto")]
    [InlineData("imagefolder", "car=auto")]
    public void Format_accepts_its_own_class_names(string format, string map)
    {
        CliRun run = CliRun.Of("export", session.Folder, "--format", format, "--out", _folder.PathOf("out"), "--map", map);

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
    }

    [Fact]
    public void Roads_of_a_file_stand_in_for_those_of_the_session()
    {
        string roads = Path.Combine(session.Folder, FramePaths.Roads);
        string copy = _folder.PathOf("session");
        foreach (string file in Directory.EnumerateFiles(session.Folder, "*", SearchOption.AllDirectories).Where(file => file != roads))
        {
            string target = Path.Combine(copy, Path.GetRelativePath(session.Folder, file));
            Directory.CreateDirectory(Path.GetDirectoryName(target)!);
            File.Copy(file, target);
        }

        CliRun
            .Of("export", copy, "--format", "openlane-v2", "--out", _folder.PathOf("out"))
            .AssertFailed(
                ExitCode.BadData,
                $"{copy}, frame 0: its session has no scenes/roads.csv, from which openlane-v2 takes the lanes. "
                    + "Name the roads with --roads, or choose another format."
            );
        CliRun.Of("export", copy, "--format", "openlane-v2", "--out", _folder.PathOf("out"), "--roads", roads).AssertDone();
        CliRun.Of("export", session.Folder, "--format", "openlane-v2", "--out", _folder.PathOf("kept")).AssertDone();
        string[] frames = [.. Directory.EnumerateFiles(_folder.PathOf("kept"), "*-ls.json", SearchOption.AllDirectories)];
        Assert.Equal(2, frames.Length);
        Assert.All(
            frames,
            frame =>
                Assert.Equal(
                    File.ReadAllText(frame).Replace($"\"{Path.GetFileName(session.Folder)}\"", "\"session\"", StringComparison.Ordinal),
                    File.ReadAllText(_folder.PathOf(Path.Combine("out", Path.GetRelativePath(_folder.PathOf("kept"), frame))))
                )
        );
        CliRun
            .Of("export", copy, "--format", "openlane", "--out", _folder.PathOf("other"), "--roads", roads)
            .AssertFailed(ExitCode.Usage, "--roads has no effect in openlane, only in openlane-v2, gpudrive, womd.");
    }

    [Theory]
    [InlineData("tusimple")]
    [InlineData("openlane")]
    [InlineData("deepdriving")]
    [InlineData("webdataset")]
    [InlineData("motchallenge")]
    [InlineData("culane")]
    public void Names_have_no_effect_on_formats_without_own_classes(string format) =>
        CliRun
            .Of("export", session.Folder, "--format", format, "--out", _folder.PathOf("out"), "--map", "car=auto")
            .AssertFailed(
                ExitCode.Usage,
                $"--map has no effect in {format}, only in kitti, kitti-tracking, coco, coco-panoptic, yolo, yolo-segment, voc, "
                    + $"cityscapes, bdd100k, openlabel, imagefolder, csv, parquet."
            );

    [Fact]
    public void Unknown_subclass_is_refused() =>
        CliRun
            .Of("export", session.Folder, "--format", "yolo", "--out", _folder.PathOf("out"), "--subclasses", "colour")
            .AssertFailed(ExitCode.Usage, "--subclasses takes mutcd, light or mutcd,light, not 'colour'.");

    [Fact]
    public void Summary_counts_ignore_regions()
    {
        var result = new ExportResult(DatasetFormats.Find("kitti")!, 4, IsFinished: true)
        {
            Labels = 20,
            Objects = 12,
            Ignored = 3,
            FramesOfSplits = new Dictionary<string, int> { ["train"] = 4 },
        };

        Assert.Equal(
            "out: kitti, 4 frames (train 4), 12 of 20 labels written, 3 regions marked as ignored",
            ExportSummary.Of("out", result)
        );
    }

    [Theory]
    [InlineData("coco", "197 of 247 labels written; 50 of 247 labels not written: posts")]
    [InlineData("cityscapes", "197 of 247 labels written; 50 of 247 labels written as poles: posts")]
    public void Summary_counts_posts(string format, string counts)
    {
        var result = new ExportResult(DatasetFormats.Find(format)!, 4, IsFinished: true)
        {
            Labels = 247,
            Posts = 50,
            Objects = 197,
            FramesOfSplits = new Dictionary<string, int> { ["train"] = 4 },
        };

        Assert.Equal($"out: {format}, 4 frames (train 4), {counts}", ExportSummary.Of("out", result));
    }

    [Fact]
    public void Summary_counts_omitted_frames()
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
            CliRun run = CliRun.Of("export", session.Folder, "--format", "csv", "--out", _folder.PathOf("shards"), "--shard", shard);
            Assert.Contains($"shard {shard} of csv", run.Out, StringComparison.Ordinal);
        }

        CliRun merge = CliRun.Of("merge", _folder.PathOf("shards"), "--out", _folder.PathOf("out"));

        Assert.Equal(ExitCode.Done, merge.ExitCode);
        Assert.True(File.Exists(_folder.PathOf("out/export.json")));
    }

    [Theory]
    [InlineData("--format", "pascal", "--format takes one of kitti, ")]
    [InlineData("--split", "train", "--split takes names with fractions")]
    [InlineData("--split", "train:0.5,val:0.1", "add up to 1")]
    [InlineData("--classes", "cars", "--classes takes a comma-separated list of car, ")]
    [InlineData("--min-visible", "2", "--min-visible takes a number from 0 to 1")]
    [InlineData("--shard", "3/2", "--shard takes I/N with I from 1 to N, e.g. 1/8")]
    [InlineData("--map", "cars=Car", "--map takes classes with names, e.g. bus=Car,truck=Car, not 'cars=Car'.")]
    [InlineData("--map", "car=", "--map takes classes with names, e.g. bus=Car,truck=Car, not 'car='.")]
    [InlineData("--map", "car=A,car=B", "--map names car twice.")]
    public void Export_with_an_impossible_value_names_the_accepted_ones(string option, string value, string message)
    {
        string[] format = option == "--format" ? [] : ["--format", "csv"];

        CliRun
            .Of(["export", session.Folder, "--out", _folder.PathOf("out"), .. format, option, value])
            .AssertFailed(ExitCode.Usage, message);
    }

    [Theory]
    [InlineData("culane", "a:0.5,a_gt:0.5", "the splits 'a' and 'a_gt' would share the name 'a_gt'. Rename one of them.")]
    [InlineData("webdataset", "a_b:0.5,a-b:0.5", "the splits 'a_b' and 'a-b' would share the name 'a_b'. Rename one of them.")]
    public void Export_refuses_splits_that_the_format_cannot_keep_apart(string format, string splits, string message)
    {
        CliRun
            .Of("export", session.Folder, "--out", _folder.PathOf("out"), "--format", format, "--split", splits)
            .AssertFailed(ExitCode.Usage, $"--split: In {format}, {message}");
        Assert.False(Directory.Exists(_folder.PathOf("out")));
    }

    [Theory]
    [InlineData("--segmentation", "polygon", "coco")]
    [InlineData(
        "--classes",
        "car",
        "kitti, kitti-tracking, coco, coco-panoptic, coco-keypoints, jta, yolo, yolo-segment, voc, cityscapes, bdd100k, motchallenge, "
            + "openlabel, nuscenes, webdataset, imagefolder, mcap, csv, parquet"
    )]
    [InlineData(
        "--min-visible",
        "0.2",
        "kitti, kitti-tracking, coco, coco-panoptic, coco-keypoints, jta, yolo, yolo-segment, voc, cityscapes, bdd100k, motchallenge, "
            + "openlabel, nuscenes, webdataset, imagefolder, mcap, csv, parquet"
    )]
    [InlineData(
        "--parts",
        "none",
        "coco, coco-panoptic, yolo, yolo-segment, voc, cityscapes, bdd100k, openlabel, webdataset, imagefolder, mcap, csv, parquet"
    )]
    [InlineData("--boxes", "cuboid", "kitti, kitti-tracking, coco, yolo, voc, bdd100k, motchallenge, openlabel, imagefolder, mcap")]
    [InlineData("--subclasses", "mutcd,light", "coco, coco-panoptic, yolo, yolo-segment, voc, imagefolder")]
    [InlineData(
        "--images",
        "copy",
        "kitti, kitti-tracking, kitti-odometry, kitti-flow, middlebury-flow, euroc, coco, coco-panoptic, coco-keypoints, jta, yolo, "
            + "yolo-segment, voc, cityscapes, semantic, bdd100k, motchallenge, openlabel, nuscenes, occ3d, tusimple, culane, "
            + "openlane, openlane-v2, imagefolder, csv, parquet, video, video-lossless"
    )]
    [InlineData(
        "--split-block",
        "10",
        "kitti, kitti-flow, middlebury-flow, coco, coco-panoptic, coco-keypoints, yolo, yolo-segment, voc, cityscapes, semantic, bdd100k, "
            + "deepdriving, tusimple, culane, openlane, webdataset, imagefolder, csv, parquet"
    )]
    public void Export_refuses_an_option_that_has_no_effect_on_the_format(string option, string value, string formats)
    {
        foreach (string format in DatasetFormats.All.Where(format => format.Program is null).Select(format => format.Name))
        {
            CliRun run = CliRun.Of("export", session.Folder, "--out", _folder.PathOf(format), "--format", format, option, value);
            if (formats.Split(", ").Contains(format))
            {
                Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
            }
            else
            {
                run.AssertFailed(ExitCode.Usage, $"{option} has no effect in {format}, only in {formats}.");
                Assert.False(Directory.Exists(_folder.PathOf(format)));
            }
        }
    }

    [Fact]
    public void Export_of_a_session_that_is_named_twice_is_refused()
    {
        CliRun
            .Of("export", session.Folder, session.Folder + "/", "--format", "csv", "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.Usage, $"'{session.Folder}' is given twice");

        Assert.False(Directory.Exists(_folder.PathOf("out")));
    }

    [Theory]
    [InlineData("export", "session", "--format", "csv")]
    [InlineData("merge", "shards")]
    [InlineData("harvest")]
    [InlineData("drive")]
    public void Occupied_output_folder_is_a_usage_error(params string[] command)
    {
        foreach (string shard in (string[])["1/2", "2/2"])
        {
            CliRun.Of("export", session.Folder, "--format", "csv", "--out", _folder.PathOf("shards"), "--shard", shard);
        }

        string[] words =
        [
            .. command.Select(word =>
                word == "session" ? session.Folder
                : word == "shards" ? _folder.PathOf(word)
                : word
            ),
        ];

        CliRun run = CliRun.Of([.. words, "--out", session.Folder]);

        run.AssertFailed(ExitCode.Usage, session.Folder);
        Assert.Contains("Name another folder", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Export_of_a_malformed_line_names_its_session()
    {
        Directory.CreateDirectory(_folder.PathOf("other"));
        File.Copy(Path.Combine(session.Folder, "session.json"), _folder.PathOf("other/session.json"));
        _folder.File("other/labels.jsonl", "{}\n");

        CliRun
            .Of("export", session.Folder, _folder.PathOf("other"), "--format", "csv", "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.BadData, $"{_folder.PathOf("other/labels.jsonl")}, line 1: frame is missing.");
    }

    [Fact]
    public void Export_of_a_missing_session_is_an_input_error() =>
        CliRun
            .Of("export", "no-such-session", "--format", "csv", "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.InputOutput, "no-such-session");

    [Fact]
    public void Merge_of_a_finished_dataset_reports_that_it_is_complete()
    {
        CliRun.Of("export", session.Folder, "--format", "csv", "--out", _folder.PathOf("whole"));

        CliRun
            .Of("merge", _folder.PathOf("whole"), "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.BadData, "is a complete dataset, not a shard.");
    }

    [Fact]
    public void Merge_of_a_folder_without_shards_is_a_data_error() =>
        CliRun
            .Of("merge", session.Folder, "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.BadData, "is a complete session, not a shard");
}
