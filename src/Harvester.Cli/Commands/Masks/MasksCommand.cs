using System.CommandLine;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Commands.Masks;

/// <summary>harvester masks: the instance masks of a session.</summary>
internal static class MasksCommand
{
    public static Command Create(Terminal terminal)
    {
        var command = new Command("masks", "Import instance masks into a session.");
        command.Subcommands.Add(MasksImportCommand.Create(terminal));
        return command;
    }
}
