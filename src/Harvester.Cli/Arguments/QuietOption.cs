using System.CommandLine;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Arguments;

/// <summary>--quiet: omits progress and summaries. Commands whose result is what they print still print it.</summary>
internal static class QuietOption
{
    public static Option<bool> Create() =>
        new("--quiet", "-q")
        {
            Description = "Omit progress and summaries; errors and warnings still go to standard error",
            Recursive = true,
        };

    /// <summary>The terminal for a command line: without standard output if the command is to be quiet.</summary>
    public static Terminal TerminalFor(ParseResult parsed, Option<bool> quiet, Terminal terminal) =>
        parsed.GetValue(quiet) && parsed.CommandResult.Command is not ResultCommand
            ? terminal with
            {
                Out = TextWriter.Null,
                IsInteractive = false,
            }
            : terminal;
}
