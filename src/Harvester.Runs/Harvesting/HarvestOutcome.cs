using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;

namespace Harvester.Runs.Harvesting;

/// <summary>The result of a harvest.</summary>
/// <param name="Frames">Number of frames written.</param>
/// <param name="Discarded">Number of frames that were begun and discarded.</param>
/// <param name="Elapsed">Duration, in real time.</param>
/// <param name="Fault">The fault that ended it early; null if it ended normally.</param>
/// <param name="IsDiskFault">Whether the fault is a write error.</param>
/// <param name="IsCancelled">Whether the user stopped it.</param>
public sealed record HarvestOutcome(int Frames, int Discarded, TimeSpan Elapsed, string? Fault, bool IsDiskFault, bool IsCancelled)
{
    /// <summary>Number of the frames that the session held from an earlier run.</summary>
    public int Resumed { get; init; }

    /// <summary>Checks that could not be made.</summary>
    public IReadOnlyList<string> Warnings { get; init; } = [];

    /// <summary>The freeze methods that were tried; null if the method was given.</summary>
    public FreezeReport? Freezing { get; init; }

    /// <summary>How well masks from rays agree with those from photographs; null if they were not compared.</summary>
    public MaskComparison? Masks { get; init; }

    /// <summary>New frames per second of real time.</summary>
    public double FramesPerSecond => Elapsed > TimeSpan.Zero ? (Frames - Resumed) / Elapsed.TotalSeconds : 0;
}
