namespace Harvester.Capture.Harvesting;

/// <summary>A harvest after a tick.</summary>
/// <param name="Phase">What it is doing.</param>
/// <param name="Captured">Frames handed to the sink.</param>
/// <param name="Discarded">Frames begun and thrown away, for whatever reason.</param>
/// <param name="FramesPerSecond">Frames handed to the sink per second of the player's time, over the whole harvest; 0 before the
/// first.</param>
/// <param name="Fault">One line that says what went wrong and what to do; null without a fault.</param>
public readonly record struct HarvestStatus(HarvestPhase Phase, int Captured, int Discarded, double FramesPerSecond, string? Fault)
{
    /// <summary>Whether the harvest has ended: no further step does anything.</summary>
    public bool IsOver => Phase is HarvestPhase.Stopped or HarvestPhase.Faulted;
}
