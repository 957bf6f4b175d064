using Harvester.Runs.Harvesting;

namespace Harvester.Cli.Terminals;

/// <summary>What the command's exit codes mean; they are part of its interface and listed in --help.</summary>
internal static class ExitCode
{
    /// <summary>Success.</summary>
    public const int Done = 0;

    /// <summary>Bad data: a session or log with problems, a malformed file.</summary>
    public const int BadData = 1;

    /// <summary>Error on the command line, including an occupied output folder.</summary>
    public const int Usage = 2;

    /// <summary>A file cannot be read or written, or a bridge to another program failed.</summary>
    public const int InputOutput = 3;

    /// <summary>The simulated game failed, or a calibration or harvest refused its result.</summary>
    public const int HarvestFault = 4;

    /// <summary>A fault of this program, to be reported; EX_SOFTWARE of sysexits.h.</summary>
    public const int ProgramFault = 70;

    /// <summary>Stopped by Ctrl+C (SIGINT: 128 + 2); what was written is valid.</summary>
    public const int Cancelled = 130;

    /// <summary>Stopped by SIGTERM (128 + 15); what was written is valid.</summary>
    public const int Terminated = 143;

    /// <summary>The exit code of a harvest.</summary>
    public static int Of(HarvestOutcome outcome) =>
        outcome switch
        {
            { IsDiskFault: true } => InputOutput,
            { Fault: not null } => HarvestFault,
            { IsCancelled: true } => Cancelled,
            _ => Done,
        };
}
