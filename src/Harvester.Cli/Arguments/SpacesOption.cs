using System.CommandLine;
using System.IO;

namespace Harvester.Cli.Arguments;

/// <summary>The option that names a table of faces and heads, the same wherever a command has it.</summary>
internal static class SpacesOption
{
    /// <summary>The option.</summary>
    /// <param name="before">Before what other table it goes, as in "the recorded one".</param>
    public static Option<FileSystemInfo?> Create(string before) => new("--spaces")
    {
        Description = $"Faces of signs and heads of lights by this table, before {before}; a survey's folder stands for the table in it",
        HelpName = "FILE|DIR",
    };
}
