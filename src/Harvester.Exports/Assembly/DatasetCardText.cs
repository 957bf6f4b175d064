using System.Text;
using Harvester.Exports.Formats.Yolo;

namespace Harvester.Exports.Assembly;

/// <summary>The parts of a dataset card that the Hugging Face hub and its users need: the YAML header and an example of loading.</summary>
internal static class DatasetCardText
{
    /// <summary>The hub's categories of sizes, by their upper limits.</summary>
    private static readonly (int Below, string Category)[] Sizes =
    [
        (1_000, "n<1K"),
        (10_000, "1K<n<10K"),
        (100_000, "10K<n<100K"),
        (1_000_000, "100K<n<1M"),
        (10_000_000, "1M<n<10M"),
        (int.MaxValue, "10M<n<100M"),
    ];

    /// <summary>The header between lines of three hyphens.</summary>
    public static string Header(DatasetCard card, ExportResult result)
    {
        var text = new StringBuilder("---\npretty_name: Driving images with labels\nlicense: unknown\n");
        text.Append("task_categories:\n- object-detection\n");
        text.Append("size_categories:\n- ").Append(SizeOf(result.Frames)).Append('\n');
        text.Append("tags:\n- autonomous-driving\n- synthetic\n- ").Append(card.Reader).Append('\n');
        text.Append("configs:\n- config_name: default\n  data_files:\n");
        foreach (string split in result.FramesOfSplits.Keys)
        {
            text.Append("  - split: ")
                .Append(YamlScalar.Of(DatasetCard.NameOf(split)))
                .Append("\n    path: '")
                .Append(card.FilesOf(split))
                .Append("'\n");
        }

        return text.Append("---\n\n").ToString();
    }

    /// <summary>A program of three lines that reads a sample.</summary>
    public static string Example(DatasetCard card) =>
        $$"""
            ## Loading

            Python's `datasets` reads the folder (`{{card.Reader}}`):

            ```python
            from datasets import load_dataset
            splits = load_dataset("DIR", streaming=True)
            print({name: next(iter(split)) for name, split in splits.items()})
            ```


            """.ReplaceLineEndings("\n");

    private static string SizeOf(int frames)
    {
        foreach ((int below, string category) in Sizes)
        {
            if (frames < below)
            {
                return category;
            }
        }

        return Sizes[^1].Category;
    }
}
