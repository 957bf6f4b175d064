using System.CommandLine;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Arguments;

/// <summary>--sync: when a writer waits for the disk.</summary>
internal static class SyncOption
{
    /// <summary>Creates the option; the default is <see cref="SyncMode.Batch"/>.</summary>
    public static Option<SyncMode> Create() =>
        ValueParsers.Choice<SyncMode>(
            "--sync",
            "When to wait until files are on the disk: batch (up to 16 frames at once), always (every frame) or never [default: batch]"
        );
}
