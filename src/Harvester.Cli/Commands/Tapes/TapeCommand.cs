using System.CommandLine;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Commands.Tapes;

/// <summary>harvester tape: works with recordings of what passes between the mod and the game.</summary>
internal static class TapeCommand
{
    public static Command Create(Terminal terminal)
    {
        var command = new Command("tape", "Play a recording of the mod's calls to the game.");
        command.Subcommands.Add(TapePlayCommand.Create(terminal));
        HelpWithNotes.AddTo(command, TapePlayCommand.Examples);
        return command;
    }
}
