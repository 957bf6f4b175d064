using System.CommandLine;
using System.IO;

namespace Harvester.Cli.Arguments;

/// <summary>The option that names a table of faces and heads, the same wherever a command has it.</summary>
internal static class SpacesOption
{
    /// <summary>The option.</summary>
    /// <param name="overridden">The table that it takes precedence over, e.g. "the recorded table".</param>
    public static Option<FileSystemInfo?> Create(string overridden) => new("--spaces")
    {
        Description = $"Table of sign faces and traffic light heads, or the folder of a survey; takes precedence over {overridden}",
        HelpName = "FILE|DIR",
    };
}
