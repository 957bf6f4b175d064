namespace Harvester.Capture.Harvesting;

/// <summary>The state of a harvest after a tick.</summary>
/// <param name="Phase">The current phase.</param>
/// <param name="Captured">Frames handed to the sink.</param>
/// <param name="Discarded">Frames begun and discarded, for any reason.</param>
/// <param name="FramesPerSecond">Frames handed to the sink per second of real time, over the whole harvest; 0 before the first.</param>
/// <param name="Fault">What went wrong and what to do, in one line; null without a fault.</param>
public readonly record struct HarvestStatus(HarvestPhase Phase, int Captured, int Discarded, double FramesPerSecond, string? Fault)
{
    /// <summary>Whether the harvest has ended: no further step does anything.</summary>
    public bool IsOver => Phase is HarvestPhase.Stopped or HarvestPhase.Faulted;
}
