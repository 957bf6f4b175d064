using System.CommandLine;
using Harvester.Runs.Faults;

namespace Harvester.Cli.Arguments;

/// <summary>--resume of the commands that derive a session or dataset from others.</summary>
internal static class ResumeOption
{
    /// <summary>Name of the option.</summary>
    public const string Name = "--resume";

    /// <summary>Creates the option.</summary>
    public static Option<bool> Create() => new(Name) { Description = "Continue an unfinished run of the same command, or start one" };

    /// <summary>Refuses --resume beside --overwrite.</summary>
    /// <exception cref="UsageException">Both are given.</exception>
    public static void Check(bool resumes, bool overwrites)
    {
        if (resumes && overwrites)
        {
            throw new UsageException("--resume continues a session, and --overwrite replaces it. Give only one of them.");
        }
    }
}
