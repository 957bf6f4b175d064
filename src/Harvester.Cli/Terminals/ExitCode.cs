namespace Harvester.Cli.Terminals;

/// <summary>What the command's exit codes mean; they are part of its interface and listed in --help.</summary>
internal static class ExitCode
{
    /// <summary>Everything asked for was done.</summary>
    public const int Done = 0;

    /// <summary>The data is at fault: a session or logs with problems, a malformed file.</summary>
    public const int BadData = 1;

    /// <summary>The command line is at fault, or names a folder for output that holds something else.</summary>
    public const int Usage = 2;

    /// <summary>A file cannot be read or written, missing, read-only, disk full, or a bridge to another program failed.</summary>
    public const int InputOutput = 3;

    /// <summary>The game failed; what was written until then is whole.</summary>
    public const int HarvestFault = 4;

    /// <summary>Stopped by Ctrl+C (SIGINT: 128 + 2); what was written until then is whole.</summary>
    public const int Cancelled = 130;

    /// <summary>Stopped by SIGTERM (128 + 15); what was written until then is whole.</summary>
    public const int Terminated = 143;
}
