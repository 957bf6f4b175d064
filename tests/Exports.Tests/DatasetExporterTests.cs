using Harvester.Datasets.Files;
using Harvester.Datasets.Sharding;
using Harvester.Exports.Assembly;
using Harvester.Exports.Formats;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>Behaviour of every format: the same bytes again and in shards, and what is rejected.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class DatasetExporterTests(SimulatedSession simulated) : ExportTests
{
    internal static readonly ExportOptions TwoSplits = new() { Splits = new SplitPlan([new("train", 0.5), new("val", 0.5)], 1, 1) };

    public static TheoryData<string> Formats =>
        [.. DatasetFormats.All.Where(format => format.Program is null).Select(format => format.Name)];

    /// <summary>Two splits of one session's frames; one where the session stays whole.</summary>
    internal static ExportOptions SplitsOf(string format) => DatasetFormats.Find(format)!.KeepsSequences ? new ExportOptions() : TwoSplits;

    [Theory]
    [MemberData(nameof(Formats))]
    public void Export_twice_gives_the_same_bytes(string format)
    {
        ExportResult result = Folder.Export(format, simulated.OpenFor(format), SplitsOf(format), "a");
        Folder.Export(format, simulated.OpenFor(format), SplitsOf(format) with { Images = ImageTransfer.Copy }, "b", sync: SyncMode.Batch);

        Assert.Equal(SimulatedSession.Frames, result.Frames + result.FramesLeftOut);
        Assert.True(result.Labels > SimulatedSession.Frames);
        Assert.Equal(result.Format.HasObjects, result.Objects > 0);
        Assert.Equal(Folder.Contents("a"), Folder.Contents("b"));
        Assert.DoesNotContain(
            Folder.Contents("a").Keys,
            name => name.Contains("partial", StringComparison.Ordinal) || name.StartsWith('.')
        );
    }

    [Theory]
    [MemberData(nameof(Formats))]
    [Trait("Category", "Heavy")]
    public void Merge_of_shards_gives_the_bytes_of_a_single_run(string format)
    {
        Folder.Export(format, [simulated.OpenFor(format), simulated.OpenFor(format)], TwoSplits, "single");
        for (int number = 1; number <= 3; number++)
        {
            // The first two share a folder, as runs on one file system may.
            string folder = number < 3 ? "a" : "b";
            Folder.Export(format, [simulated.OpenFor(format), simulated.OpenFor(format)], TwoSplits, folder, new Shard(number, 3));
        }

        DatasetMerger.Merge([Folder.PathOf("a"), Folder.PathOf("b")], Folder.PathOf("merged"), new MergeOptions(ImageTransfer.Link));

        Assert.Equal(Folder.Contents("single"), Folder.Contents("merged"));
    }

    [Fact]
    public void Export_into_a_folder_with_other_files_is_refused()
    {
        Directory.CreateDirectory(Folder.PathOf("out"));
        File.WriteAllText(Folder.PathOf("out/thesis.tex"), "mine");

        Assert.Throws<OccupiedFolderException>(() => Folder.Export("csv", simulated.Open()));
    }

    /// <summary>Reading the labels of long sessions takes minutes.</summary>
    [Fact]
    public void Export_refuses_an_occupied_folder_before_reading_labels()
    {
        Directory.CreateDirectory(Folder.PathOf("out"));
        File.WriteAllText(Folder.PathOf("out/thesis.tex"), "mine");
        Session.Car(1).Remove("box3d");

        Assert.Throws<OccupiedFolderException>(() => Folder.Export("csv", Session.Open()));
    }

    [Fact]
    public void Export_into_a_finished_dataset_is_refused()
    {
        Folder.Export("csv", simulated.Open());

        Assert.Throws<OccupiedFolderException>(() => Folder.Export("csv", simulated.Open()));
    }

    [Theory]
    [InlineData("tusimple", "it has no lanes")]
    [InlineData("cityscapes", "it has no mask")]
    public void Export_without_the_data_a_format_needs_leaves_no_folder(string format, string message)
    {
        Session.Lines[0].Remove("mask");

        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() => Folder.Export(format, Session.Open()));

        Assert.Contains(message, refused.Message, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Folder.PathOf("out")));
    }

    [Fact]
    public void Merge_without_all_shards_is_refused()
    {
        Folder.Export("csv", simulated.Open(), to: "a", shard: new Shard(1, 3));
        Folder.Export("csv", simulated.Open(), to: "b", shard: new Shard(3, 3));

        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() =>
            DatasetMerger.Merge([Folder.PathOf("a"), Folder.PathOf("b")], Folder.PathOf("out"), default)
        );

        Assert.Equal("Shard 2 is missing; run it, and name its folder too.", refused.Message);
    }

    [Fact]
    public void Merge_of_shards_of_different_exports_is_refused()
    {
        Folder.Export("csv", simulated.Open(), to: "a", shard: new Shard(1, 2));
        Folder.Export("csv", simulated.Open(), TwoSplits, "b", new Shard(2, 2));

        Assert.Throws<DatasetFormatException>(() =>
            DatasetMerger.Merge([Folder.PathOf("a"), Folder.PathOf("b")], Folder.PathOf("out"), default)
        );
    }

    [Fact]
    public void Merge_with_an_unfinished_shard_is_refused()
    {
        Folder.Export("csv", simulated.Open(), to: "a", shard: new Shard(1, 2));
        using var stop = new CancellationTokenSource();
        Assert.Throws<OperationCanceledException>(() =>
            new DatasetExporter(ExportFolder.Plan("csv", [simulated.Open()]), Folder.PathOf("b"), new Shard(2, 2)).Run(
                _ => stop.Cancel(),
                stop.Token
            )
        );

        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() =>
            DatasetMerger.Merge([Folder.PathOf("a"), Folder.PathOf("b")], Folder.PathOf("out"), default)
        );

        Assert.Contains("Shard 2/2", refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Export_with_filters_omits_the_rest()
    {
        // The pedestrian is of another class; the car is seen to (1 - 0)(1 - 0.25) = 0.75.
        Session.DeterminePedestrians();
        Assert.Equal(3, Folder.Export("csv", Session.Open(), new ExportOptions { Classes = [ObjectClass.Car] }, "car").Objects);
        Assert.Equal(6, Folder.Export("csv", Session.Open(), new ExportOptions { MinVisibleFraction = 0.75 }, "seen").Objects);
        Assert.Equal(3, Folder.Export("csv", Session.Open(), new ExportOptions { MinVisibleFraction = 0.76 }, "more").Objects);
        Assert.Equal(0, Folder.Export("csv", Session.Open(), new ExportOptions { MinVisibleFraction = 0.81 }, "most").Objects);
    }

    [Fact]
    public void Export_of_parts_or_whole_objects_omits_the_others()
    {
        // The pedestrian of the second frame is a part of the car, whatever that may be.
        Session.Lines[1]["objects"]![1]!["parent"] = 1;

        Assert.Equal(6, Folder.Export("csv", Session.Open(), to: "all").Objects);
        Assert.Equal(5, Folder.Export("csv", Session.Open(), new ExportOptions { Parts = PartSelection.None }, "none").Objects);
        Assert.Equal(1, Folder.Export("csv", Session.Open(), new ExportOptions { Parts = PartSelection.Only }, "only").Objects);
        Assert.EndsWith(",1,,,,", Folder.Lines("only/objects.csv")[1], StringComparison.Ordinal);
        Assert.EndsWith(",,,,,", Folder.Lines("none/objects.csv")[1], StringComparison.Ordinal);
    }

    [Fact]
    public void Shards_start_in_a_folder_whose_plan_is_still_being_written()
    {
        Directory.CreateDirectory(Folder.PathOf("out/.export"));
        using var other = new FileStream(
            Folder.PathOf("out/.export/plan.json.0123456789abcdef.partial"),
            FileMode.CreateNew,
            FileAccess.Write,
            FileShare.None
        );

        Assert.Equal(2, Folder.Export("csv", Session.Open(), shard: new Shard(1, 2)).Frames);
        Assert.Equal(1, Folder.Export("csv", Session.Open(), shard: new Shard(2, 2)).Frames);
    }

    [Fact]
    public void Export_of_a_malformed_line_names_file_line_and_field()
    {
        Session.Car(1).Remove("box3d");

        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() => Folder.Export("kitti", Session.Open()));

        Assert.Equal($"{Session.PathOf("labels.jsonl")}, line 2: objects[0].box3d is missing.", refused.Message);
    }

    [Fact]
    public void Export_of_an_image_outside_the_session_is_refused()
    {
        Session.Lines[1]["image"] = "../secret.png";

        Assert.Contains(
            "points outside the session",
            Assert.Throws<DatasetFormatException>(() => Folder.Export("csv", Session.Open())).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Export_of_a_missing_image_names_it()
    {
        File.Delete(Session.PathOf("frames/00000001.png"));

        Assert.Contains(
            "00000001.png' is missing",
            Assert.Throws<DatasetFormatException>(() => Folder.Export("csv", Session.Open())).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Export_of_a_mask_without_pixels_names_it()
    {
        File.WriteAllBytes(
            Session.PathOf("masks/00000000.png"),
            TestImages.PngWithoutPixels(TestSession.Width, TestSession.Height, bitDepth: 16, colourType: 0)
        );

        Assert.Contains(
            "masks/00000000.png",
            Assert.Throws<DatasetFormatException>(() => Folder.Export("coco", Session.Open())).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Export_without_masks_to_a_format_that_needs_them_is_refused()
    {
        Session.Lines[0]["mask"] = null;

        Assert.Contains(
            "it has no mask",
            Assert.Throws<DatasetFormatException>(() => Folder.Export("yolo-segment", Session.Open())).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Export_of_a_bent_lens_to_kitti_is_refused()
    {
        Session.Lines[2]["camera"]!["distortion"]!["k1"] = 0.05;

        Assert.Contains(
            "bends straight lines",
            Assert.Throws<DatasetFormatException>(() => Folder.Export("kitti", Session.Open())).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Export_to_kitti_accepts_a_lens_distortion_below_a_pixel()
    {
        // What a calibration finds of a straight lens: 0.0002 · r³ · f is under 0.1 pixels in the corner of an image of 90 degrees.
        Session.Lines[2]["camera"]!["distortion"]!["k1"] = 0.0002;

        Folder.Export("kitti", Session.Open());
    }
}
