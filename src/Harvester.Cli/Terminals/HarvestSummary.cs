using System.Globalization;
using Harvester.Capture.Labelling;
using Harvester.Datasets.Statistics;
using Harvester.Runs.Harvesting;
using Harvester.Runs.Supervising;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;
using Spectre.Console;

namespace Harvester.Cli.Terminals;

/// <summary>Prints the counts of a harvest, its folder, and the command to run next.</summary>
internal static class HarvestSummary
{
    private static readonly string[] Columns = ["class", "labels", "objects", "nearest", "median distance"];

    public static void Write(Terminal terminal, HarvestPlan plan, HarvestOutcome outcome, SessionStatistics statistics, string? report)
    {
        if (terminal.IsInteractive)
        {
            WriteTable(terminal, statistics.Classes.Select(Row));
        }
        else
        {
            WriteLines(terminal, statistics.Classes);
        }

        string counts = $"{Counted.Of(outcome.Frames, "frame")}, {Counted.Of(statistics.Labels, "label")}";
        string rate = FormattableString.Invariant($"{outcome.Elapsed.TotalSeconds:0.0} s ({outcome.FramesPerSecond:0.0} frames/s)");
        string resumed = outcome.Resumed > 0 ? $", {outcome.Resumed} of them from an earlier run" : "";
        terminal.Out.WriteLine($"{counts} in {rate}{resumed}, {Counted.Of(outcome.Discarded, "frame")} discarded");
        if (outcome.Freezing is { } freezing)
        {
            terminal.Out.WriteLine($"freeze   {freezing}");
        }

        foreach (MaskAgreement each in outcome.Masks?.Classes ?? [])
        {
            string compared = Counted.Of(each.Objects, "object");
            terminal.Out.WriteLine(
                FormattableString.Invariant(
                    $"masks    {JsonName.Of(each.Class)}: rays and photographs agree with an IoU of {each.MeanIou:0.000} ({compared})"
                )
            );
        }

        if (outcome.Masks is { ObjectPixels: > 0 } masks)
        {
            terminal.Out.WriteLine(
                FormattableString.Invariant(
                    $"masks    {100.0 * masks.DifferentPixels / masks.ObjectPixels:0.0} % of the pixels of objects differ"
                )
            );
        }

        terminal.Out.WriteLine($"session  {plan.Folder}");
        if (report is not null)
        {
            terminal.Out.WriteLine($"report   {report}");
        }

        terminal.Out.WriteLine(
            plan.Survey is not null ? $"next     {Command()} roads paint {ShellWord.Of(plan.Folder)} --out paint.csv"
            : plan.Options.Shard.Count > 1 ? $"next     {Command()} merge {ShellWord.Of(plan.Folder)} OTHER SHARDS... --out DIR"
            : $"next     {Command()} validate {ShellWord.Of(plan.Folder)}"
        );
    }

    private static string[] Row(KeyValuePair<ObjectClass, ClassStatistics> kind) =>
        [
            JsonName.Of(kind.Key),
            kind.Value.Labels.ToString(CultureInfo.InvariantCulture),
            kind.Value.Objects.ToString(CultureInfo.InvariantCulture),
            string.Create(CultureInfo.InvariantCulture, $"{kind.Value.MinMetres:0.0} m"),
            string.Create(CultureInfo.InvariantCulture, $"{kind.Value.MedianDistanceMetres:0.0} m"),
        ];

    private static void WriteTable(Terminal terminal, IEnumerable<string[]> rows)
    {
        Table table = new Table().RoundedBorder();
        foreach (string column in Columns)
        {
            table.AddColumn(column, heading => heading.Alignment(column == Columns[0] ? Justify.Left : Justify.Right));
        }

        foreach (string[] row in rows)
        {
            table.AddRow(row);
        }

        terminal.ToAnsiConsole().Write(table);
    }

    private static void WriteLines(Terminal terminal, IEnumerable<KeyValuePair<ObjectClass, ClassStatistics>> classes)
    {
        foreach ((ObjectClass kind, ClassStatistics figures) in classes)
        {
            string counts = $"{Counted.Of(figures.Labels, "label")}, {Counted.Of(figures.Objects, "object")}";
            string distances = FormattableString.Invariant(
                $"nearest {figures.MinMetres:0.0} m, median distance {figures.MedianDistanceMetres:0.0} m"
            );
            terminal.Out.WriteLine($"{JsonName.Of(kind)}: {counts}, {distances}");
        }
    }

    /// <summary>The command to type in the current folder: in a clone of the repository, harvester is not on the path.</summary>
    private static string Command() =>
        File.Exists(Path.Combine("src", "Harvester.Cli", "Harvester.Cli.csproj"))
            ? "dotnet run -c Release --project src/Harvester.Cli --"
            : "harvester";
}
