using System.CommandLine;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads: imports, compares and draws road networks, and writes their node database.</summary>
internal static class RoadsCommand
{
    public static Command Create(Terminal terminal)
    {
        var command = new Command("roads", "Import, compare and draw road networks, write their node database, and measure their paint.");
        command.Subcommands.Add(RoadsImportCommand.Create(terminal));
        command.Subcommands.Add(RoadsInfoCommand.Create(terminal));
        command.Subcommands.Add(RoadsCompareCommand.Create(terminal));
        command.Subcommands.Add(RoadsMapCommand.Create(terminal));
        command.Subcommands.Add(RoadsNodesCommand.Create(terminal));
        command.Subcommands.Add(RoadsPhotographCommand.Create(terminal));
        command.Subcommands.Add(RoadsPaintCommand.Create(terminal));
        HelpWithNotes.AddTo(
            command,
            RoadSourceArgument.NotesWith(
                "FROM, A and B are each",
                RoadsImportCommand.Example,
                RoadsInfoCommand.Example,
                RoadsCompareCommand.Example,
                RoadsMapCommand.Example,
                RoadsNodesCommand.Example,
                RoadsPhotographCommand.Example,
                RoadsPaintCommand.Example
            )
        );
        return command;
    }
}
