using System.Collections.Generic;
using Harvester.Capture.Labelling;

namespace Harvester.Capture.Harvesting;

/// <summary>A way to come to pictures and labels that agree: the flow of one frame over several ticks.</summary>
internal interface ICaptureFlow
{
    /// <summary>The frame that the last flow came to; null when it was discarded.</summary>
    FrameDraft? Draft { get; }

    /// <summary>Whether the last flow passed over a frame that another shard takes.</summary>
    bool IsPassed { get; }

    /// <summary>
    /// Takes one frame. Each element is a tick that ends in the given phase; disposing the sequence leaves the game running.
    /// </summary>
    IEnumerable<HarvestPhase> TakeFrame();
}
