using System.CommandLine;

namespace Harvester.Cli.Arguments;

/// <summary>--no-report. Several commands share it.</summary>
internal static class ReportOption
{
    public static Option<bool> Create() => new("--no-report") { Description = "Write no report" };
}
