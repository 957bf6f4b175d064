using System.CommandLine;

namespace Harvester.Cli.Arguments;

/// <summary>The argument that names a session. Several commands share it.</summary>
internal static class SessionArgument
{
    public static Argument<string> Create() => new("SESSION") { Description = "Folder of a session" };
}
