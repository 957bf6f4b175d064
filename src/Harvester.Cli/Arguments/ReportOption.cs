using System.CommandLine;

namespace Harvester.Cli.Arguments;

/// <summary>The option that leaves a session's report out, the same wherever a command has it.</summary>
internal static class ReportOption
{
    public static Option<bool> Create() => new("--no-report") { Description = "Write no report" };
}
