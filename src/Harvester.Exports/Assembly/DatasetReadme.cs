using System.Text;
using Harvester.Exports.Formats.Yolo;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Assembly;

/// <summary>
/// The README.md of a dataset: what it is, how it was written, and the notice about the rights to its images. Where the Hugging Face hub
/// reads the format, it is also the dataset card, whose header the hub interprets. It depends on the plan and the counts only.
/// </summary>
internal static class DatasetReadme
{
    private const string Notice = """
        ## Notice

        Images recorded in Grand Theft Auto V show content of its publisher, who holds the rights to it. The publisher's statement of June
        2017 tolerates projects for its PC games that are single-player and non-commercial, and says of itself that it "is not a license".
        Whoever uses or passes on this dataset must find out whether that is permitted. Images of the simulated game (`game` is `simulation`
        in the sessions) show nothing of Grand Theft Auto V.

        """;

    /// <summary>The text.</summary>
    /// <param name="options">Options of the export.</param>
    /// <param name="result">What was exported.</param>
    public static string Of(ExportOptions options, ExportResult result)
    {
        DatasetFormat format = result.Format;
        var text = new StringBuilder(format.Card is { } card ? DatasetCardText.Header(card, result) : "");
        text.Append("# Driving images with labels\n\n");
        text.Append(format.Description).Append(" (format `").Append(format.Name).Append("`), exported by GtaDataHarvester with\n\n```\n");
        text.Append(ExportCommandText.Of(format, options)).Append("\n```\n\n");
        text.Append("`harvester validate DIR` checks it, and `export.json` records what was exported.\n\n");
        text.Append("| split | frames |\n|---|---|\n");
        foreach ((string split, int frames) in result.FramesOfSplits)
        {
            text.Append("| ").Append(split).Append(" | ").Append(Numbers.Text(frames)).Append(" |\n");
        }

        if (format.HasObjects)
        {
            text.Append('\n').Append(Counted.Of(result.Objects, "object")).Append(". ").Append(ClassesOf(format, options)).Append('\n');
        }

        text.Append('\n');
        return text.Append(format.Card is { } hub ? DatasetCardText.Example(hub) : "").Append(Notice.ReplaceLineEndings("\n")).ToString();
    }

    private static string ClassesOf(DatasetFormat format, ExportOptions options)
    {
        IEnumerable<string> names = new ClassCatalogue(options).All.Select(kind =>
            format.HasNames ? $"{YamlScalar.Of(kind.Name)} ({Numbers.Text(kind.Number)})" : YamlScalar.Of(kind.Name)
        );
        return $"Selected classes: {string.Join(", ", names)}.";
    }
}
