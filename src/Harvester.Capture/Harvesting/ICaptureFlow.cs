using System.Collections.Generic;

namespace Harvester.Capture.Harvesting;

/// <summary>A way to obtain images and labels that agree: the flow of one frame over several ticks.</summary>
internal interface ICaptureFlow
{
    /// <summary>The frame of the last flow; null if it was discarded.</summary>
    TakenFrame? Taken { get; }

    /// <summary>Whether the last flow skipped a frame of another shard, or one that the session already holds.</summary>
    bool IsPassed { get; }

    /// <summary>Takes one frame. Each element is a tick that ends in the given phase; disposing the sequence resumes the game.</summary>
    IEnumerable<HarvestPhase> TakeFrame();
}
