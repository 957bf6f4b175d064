namespace Harvester.Cli.Tests;

/// <summary>
/// A process that was started with SIGINT ignored, as a script starts one in the background, ignores it for good, and so do those that it
/// starts: a test run too. A shell cannot undo that.
/// </summary>
internal static class HeededSignals
{
    /// <summary>The beginning of a shell script; a program that the script runs as <c>$heeding PROGRAM</c> heeds SIGINT.</summary>
    /// <remarks>It needs env of GNU. Elsewhere SIGINT stays as it was.</remarks>
    public const string Script = "heeding=; env --default-signal=INT true 2>/dev/null && heeding='env --default-signal=INT'; ";

    /// <summary>What is wrong with a process that has not ended.</summary>
    public const string NotEnded = "It has not ended. Start the tests so that they do not ignore SIGINT.";
}
