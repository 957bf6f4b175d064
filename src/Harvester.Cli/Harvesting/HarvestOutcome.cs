using System;
using System.Collections.Generic;
using Harvester.Capture.Harvesting;

namespace Harvester.Cli.Harvesting;

/// <summary>How a harvest ended.</summary>
/// <param name="Frames">Frames on disk.</param>
/// <param name="Discarded">Frames begun and thrown away.</param>
/// <param name="Elapsed">Time that it took.</param>
/// <param name="Fault">Why it ended early; null when it did not.</param>
/// <param name="IsDiskFault">Whether the fault is that the session could not be written.</param>
/// <param name="IsCancelled">Whether it was stopped by the user.</param>
internal sealed record HarvestOutcome(int Frames, int Discarded, TimeSpan Elapsed, string? Fault, bool IsDiskFault, bool IsCancelled)
{
    /// <summary>What could not be checked.</summary>
    public IReadOnlyList<string> Warnings { get; init; } = [];

    /// <summary>The ways of freezing that were tried; null when the way was given.</summary>
    public FreezeReport? Freezing { get; init; }

    /// <summary>Frames a second of the clock on the wall.</summary>
    public double FramesPerSecond => Elapsed > TimeSpan.Zero ? Frames / Elapsed.TotalSeconds : 0;

    /// <summary>The exit code that says so.</summary>
    public int ExitCode => this switch
    {
        { IsDiskFault: true } => Terminals.ExitCode.InputOutput,
        { Fault: not null } => Terminals.ExitCode.HarvestFault,
        { IsCancelled: true } => Terminals.ExitCode.Cancelled,
        _ => Terminals.ExitCode.Done,
    };
}
