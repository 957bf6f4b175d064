using Harvester.Capture.Labelling;
using Harvester.Geometry.Work;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// A way to obtain images and labels that agree: the flow of one frame, or of all views of one moment, over several ticks.
/// </summary>
internal interface ICaptureFlow
{
    /// <summary>The frame of the last flow, or the views of its moment, with their pictures; empty if it was discarded.</summary>
    IReadOnlyList<FrameDraft> Taken { get; }

    /// <summary>Whether the last flow skipped a frame of another shard, or one that the session already holds.</summary>
    bool IsPassed { get; }

    /// <summary>Game time of the last flow's frame or moment, taken or skipped; null if it was discarded.</summary>
    double? TakenSeconds { get; }

    /// <summary>Takes one frame or moment. Ending the work resumes the game.</summary>
    IEnumerable<WorkStep> TakeFrame();
}
