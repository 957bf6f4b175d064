using System.CommandLine;

namespace Harvester.Cli.Arguments;

/// <summary>--spaces: a table of sign faces and traffic light heads. Several commands share it.</summary>
internal static class SpacesOption
{
    /// <summary>Creates the option.</summary>
    /// <param name="overridden">The table over which it takes precedence, such as "the recorded table".</param>
    public static Option<FileSystemInfo?> Create(string overridden) =>
        new("--spaces")
        {
            Description = $"Table of sign faces and traffic light heads, or the folder of a survey; takes precedence over {overridden}",
            HelpName = "FILE|DIR",
        };
}
