using System.CommandLine;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Commands.Logs;

/// <summary>harvester log: brings in logs of traffic that others recorded.</summary>
internal static class LogCommand
{
    public static Command Create(Terminal terminal)
    {
        var command = new Command("log", "Import recorded traffic, which 'harvest --log' replays.");
        command.Subcommands.Add(LogImportCommand.Create(terminal));
        HelpWithNotes.AddTo(command, LogImportCommand.Examples);
        return command;
    }
}
