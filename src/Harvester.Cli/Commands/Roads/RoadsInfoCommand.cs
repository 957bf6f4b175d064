using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads info: counts what road data contains.</summary>
internal static class RoadsInfoCommand
{
    /// <summary>The example in the help.</summary>
    public const string Example = "  harvester roads info session/scenes/roads.csv";

    private const int NameColumn = 40;

    public static Command Create(Terminal terminal)
    {
        Argument<string> from = RoadSourceArgument.Create();
        Option<LanesIn> lanesIn = RoadSourceArgument.LanesIn();
        var command = new ResultCommand("info", "Count the nodes, links, flags and lanes of road data.") { from, lanesIn };
        HelpWithNotes.AddTo(command, RoadSourceArgument.NotesWith("FROM is", Example));
        command.SetAction(parsed =>
        {
            RoadImport import = RoadSourceArgument.Import(parsed, from, lanesIn, terminal);
            terminal.Out.WriteLine("format".PadRight(NameColumn) + import.Format);
            foreach ((string name, string value) in RoadSummary.Of(import.Network))
            {
                terminal.Out.WriteLine(name.PadRight(NameColumn) + value);
            }

            return ExitCode.Done;
        });
        return command;
    }
}
