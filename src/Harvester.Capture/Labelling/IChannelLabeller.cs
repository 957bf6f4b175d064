using Harvester.Geometry.Work;

namespace Harvester.Capture.Labelling;

/// <summary>Produces the part of one channel in each frame.</summary>
internal interface IChannelLabeller
{
    /// <summary>When its turn comes in the labelling of a frame.</summary>
    ChannelTurn Turn { get; }

    /// <summary>The name under which its rays are counted.</summary>
    string RaysKey { get; }

    /// <summary>Produces the part, in steps; the caller may pause after any step.</summary>
    /// <param name="draft">The frame with its mask and objects; receives the part.</param>
    /// <param name="mayCastRays">Called before each part of the work that casts rays.</param>
    IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays);
}
