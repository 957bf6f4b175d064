using Harvester.Exports.Formats;
using Harvester.Exports.Validation;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

[Collection(SimulatedSession.Collection)]
public sealed class DatasetReadmeTests(SimulatedSession simulated) : ExportTests
{
    private const string Readme = "out/README.md";

    public static TheoryData<string> Formats =>
        [.. DatasetFormats.All.Where(format => format.Program is null).Select(format => format.Name)];

    [Theory]
    [MemberData(nameof(Formats))]
    public void Readme_says_what_wrote_it_and_repeats_the_notice(string format)
    {
        Folder.Export(format, simulated.OpenFor(format));

        string text = File.ReadAllText(Folder.PathOf(Readme));
        Assert.Contains($"\nharvester export SESSION... --format {format} ", text, StringComparison.Ordinal);
        Assert.Contains("single-player and non-commercial", text, StringComparison.Ordinal);
        Assert.Contains("\"is not a license\"", text, StringComparison.Ordinal);
        Assert.DoesNotContain(simulated.Folder, text, StringComparison.Ordinal);
        Assert.DoesNotContain(Path.GetFileName(simulated.Folder), text, StringComparison.Ordinal);
        Assert.DoesNotContain(Environment.UserName + "/", text, StringComparison.Ordinal);
        Assert.DoesNotContain('\r', text);
    }

    [Fact]
    public void Command_line_has_the_options_that_are_not_the_default()
    {
        var options = new ExportOptions
        {
            Splits = new SplitPlan([new("train", 0.5), new("val", 0.5)], 1, 2),
            Classes = [ObjectClass.Car, ObjectClass.Bus],
            Names = new Dictionary<ObjectClass, string> { [ObjectClass.Bus] = "big car" },
            MinVisibleFraction = 0.25,
            Parts = PartSelection.None,
            ImageFormat = ImageFormat.Jpeg,
        };
        Folder.Export("yolo", simulated.Open(), options);

        Assert.Contains(
            "harvester export SESSION... --format yolo --split train:0.5,val:0.5 --seed 1 --split-block 2 --classes car,bus "
                + "--map 'bus=big car' --min-visible 0.25 --parts none --boxes visible --image-format jpg --quality 95 --out DIR",
            Folder.Lines(Readme)
        );
    }

    [Theory]
    [InlineData("webdataset", "train-[0-9][0-9][0-9][0-9][0-9][0-9].tar", "train-2-[0-9][0-9][0-9][0-9][0-9][0-9].tar")]
    [InlineData("imagefolder", "data/train/**", "data/train-2/**")]
    public void Card_begins_with_the_header_that_the_hub_reads(string format, string train, string validation)
    {
        var options = new ExportOptions { Splits = new SplitPlan([new("train", 0.5), new("train-2", 0.5)], 1, 1) };
        Folder.Export(format, simulated.OpenFor(format), options);

        string[] lines = Folder.Lines(Readme);
        Assert.Equal(
            [
                "---",
                "pretty_name: Driving images with labels",
                "license: unknown",
                "task_categories:",
                "- object-detection",
                "size_categories:",
                "- n<1K",
                "tags:",
                "- autonomous-driving",
                "- synthetic",
                "- " + format,
                "configs:",
                "- config_name: default",
                "  data_files:",
                "  - split: train",
                $"    path: '{train}'",
                "  - split: train_2",
                $"    path: '{validation}'",
                "---",
            ],
            lines[..19]
        );
        Assert.Contains("from datasets import load_dataset", lines);
    }

    [Fact]
    public void Readme_that_is_lost_or_changed_is_found()
    {
        Folder.Export("voc", simulated.Open());
        File.AppendAllText(Folder.PathOf(Readme), "More.\n");
        Assert.Contains(Problems(), problem => problem.StartsWith("README.md: it has ", StringComparison.Ordinal));
        File.Delete(Folder.PathOf(Readme));
        Assert.Contains("README.md: it is missing, but listed in manifest.jsonl.", Problems());
    }

    [Fact]
    public void Other_documents_beside_the_readme_are_no_problem()
    {
        Folder.Export("voc", simulated.Open());
        File.WriteAllText(Folder.PathOf("out/NOTES.md"), "Mine.\n");

        Assert.Empty(Problems());
        Assert.Equal(["NOTES.md"], DatasetValidator.Validate(Folder.PathOf("out")).OtherFiles);
    }

    private string[] Problems() => [.. DatasetValidator.Validate(Folder.PathOf("out")).Problems.Select(problem => problem.ToString())];
}
