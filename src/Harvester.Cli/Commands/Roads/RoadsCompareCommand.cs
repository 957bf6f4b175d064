using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry.Roads;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads compare: counts the links on whose direction of traffic two sources agree.</summary>
internal static class RoadsCompareCommand
{
    /// <summary>The example in the help.</summary>
    public const string Example = "  harvester roads compare paths.xml exported-ynd/";

    private const int NameColumn = 40;

    public static Command Create(Terminal terminal)
    {
        var first = new Argument<string>("A") { Description = "Road data: a file, a folder or a zip archive" };
        var second = new Argument<string>("B") { Description = "Road data from another source" };
        Option<LanesIn> lanesIn = RoadSourceArgument.LanesIn();
        var command = new ResultCommand("compare", "Match two networks by position and count the one-way links that agree.")
        {
            first,
            second,
            lanesIn,
        };
        HelpWithNotes.AddTo(command, RoadSourceArgument.NotesWith("A and B are each", Example));
        command.SetAction(parsed =>
        {
            RoadNetwork a = RoadSourceArgument.Import(parsed, first, lanesIn, terminal).Network;
            RoadNetwork b = RoadSourceArgument.Import(parsed, second, lanesIn, terminal).Network;
            NetworkComparison comparison = NetworkComparison.Of(a, b);
            Write("links of A", comparison.Links);
            Write("matched with a link of B", comparison.Matched, comparison.Links);
            Write("same lanes", comparison.SameLanes, comparison.Matched);
            Write("one-way in both", comparison.OneWayInBoth, comparison.Matched);
            Write("  same direction", comparison.SameWay, comparison.OneWayInBoth);
            Write("  opposite directions", comparison.OppositeWays, comparison.OneWayInBoth);
            Write("one-way in only one", comparison.OneWayInOne, comparison.Matched);
            return ExitCode.Done;
        });
        return command;

        void Write(string name, int count, int? of = null)
        {
            string percentage = of is > 0 ? FormattableString.Invariant($" ({100.0 * count / of:0.0} %)") : string.Empty;
            terminal.Out.WriteLine(FormattableString.Invariant($"{name.PadRight(NameColumn)}{count}{percentage}"));
        }
    }
}
