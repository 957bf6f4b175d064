using System.CommandLine;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Commands.Masks;

/// <summary>harvester masks: works with the instance masks of a session.</summary>
internal static class MasksCommand
{
    public static Command Create(Terminal terminal)
    {
        var command = new Command("masks", "Import instance masks into a session.");
        command.Subcommands.Add(MasksImportCommand.Create(terminal));
        HelpWithNotes.AddTo(command, MasksImportCommand.Examples);
        return command;
    }
}
