using System.Text.Json;
using System.Text.RegularExpressions;
using Harvester.Exports.Assembly;
using Harvester.Exports.Validation;
using Harvester.Sessions.Reading;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>An export counts what it has written: as many objects as a reader of the format finds.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class ExportCountTests(SimulatedSession simulated) : ExportTests
{
    [Theory]
    [InlineData("kitti", "training/label_2/*.txt", "\n")]
    [InlineData("kitti-tracking", "training/label_02/*.txt", "\n")]
    [InlineData("coco", "annotations/*.json", "\"category_id\"")]
    [InlineData("coco-panoptic", "annotations/*.json", "\"category_id\":([1-9]|1[01]),")]
    [InlineData("yolo", "labels/train/*.txt", "\n")]
    [InlineData("yolo-segment", "labels/train/*.txt", "\n")]
    [InlineData("voc", "Annotations/*.xml", "<bndbox>")]
    [InlineData("webdataset", "*.tar", "\"truncatedFraction\"")]
    [InlineData("bdd100k", "labels/det_20/*.json", "\"box2d\"")]
    [InlineData("motchallenge", "MOT17-train/sequence-0000/gt/gt.txt", "\n")]
    [InlineData("openlabel", "labels/train/*.json", "\"(box|region \\d+)\"")]
    public void Object_count_equals_that_of_the_files(string format, string files, string mark)
    {
        ExportResult result = Folder.Export(format, simulated.Open());

        string[] paths = Directory.GetFiles(Folder.PathOf("out/" + Path.GetDirectoryName(files)), Path.GetFileName(files));
        Assert.NotEmpty(paths);
        Assert.Equal(paths.Sum(path => Regex.Count(File.ReadAllText(path), mark)), result.Objects + result.Ignored);
    }

    [Fact]
    public void Objects_of_cityscapes_are_those_with_a_visible_pixel() =>
        Assert.Equal(
            Folder.Export("yolo-segment", simulated.Open()).Objects,
            Folder.Export("cityscapes", simulated.Open(), to: "city").Objects
        );

    [Fact]
    public void Filters_omit_labels_and_export_json_counts_both()
    {
        ExportResult all = Folder.Export("csv", simulated.Open(), to: "all");
        ExportResult some = Folder.Export("csv", simulated.Open(), new ExportOptions { MinVisibleFraction = 0.9 });

        Assert.Equal((all.Labels, all.Labels), (all.Objects, some.Labels));
        Assert.InRange(some.Objects, 1, all.Objects - 1);

        // The first line is the header.
        Assert.Equal(some.Objects, Folder.Lines("out/objects.csv").Length - 1);
        using JsonDocument manifest = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/export.json")));
        Assert.Equal(
            (some.Labels, some.Objects),
            (manifest.RootElement.GetProperty("labels").GetInt32(), manifest.RootElement.GetProperty("objects").GetInt32())
        );
    }

    [Theory]
    [InlineData("tusimple")]
    [InlineData("culane")]
    [InlineData("openlane")]
    public void Frames_without_known_lanes_are_counted_separately(string format)
    {
        string session = Folder.PathOf("session");
        foreach (string file in Directory.EnumerateFiles(simulated.Folder, "*", SearchOption.AllDirectories))
        {
            string copy = Path.Combine(session, Path.GetRelativePath(simulated.Folder, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }

        string labels = Path.Combine(session, SessionReader.LabelsFile);
        string text = new Regex("\"status\":\"known\"").Replace(File.ReadAllText(labels), "\"status\":\"ambiguous\"", 1);
        File.WriteAllText(labels, text);
        int known = Regex.Count(text, "\"status\":\"known\"");
        Assert.InRange(known, 1, SimulatedSession.Frames - 1);

        ExportResult result = Folder.Export(format, new SessionReader(session));

        Assert.Equal(
            (known, SimulatedSession.Frames - known, known),
            (result.Frames, result.FramesLeftOut, result.FramesOfSplits["train"])
        );
        Assert.Equal(known, Pictures().Length);
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void Frames_are_counted_by_split()
    {
        var options = new ExportOptions { Splits = new SplitPlan([new("train", 0.5), new("val", 0.5)], 5, 1) };

        ExportResult result = Folder.Export("yolo", simulated.Open(), options);

        foreach (string split in (string[])["train", "val"])
        {
            Assert.Equal(Directory.GetFiles(Folder.PathOf("out/images/" + split)).Length, result.FramesOfSplits[split]);
        }
    }

    /// <summary>The images of the frames; culane's maps are images too.</summary>
    private string[] Pictures() =>
        [
            .. Directory
                .GetFiles(Folder.PathOf("out"), "*.png", SearchOption.AllDirectories)
                .Where(path => !path.Contains("laneseg_label", StringComparison.Ordinal)),
        ];
}
