using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Labelling;

/// <summary>One of the views of each moment of a rig.</summary>
/// <param name="Camera">The camera that has it.</param>
/// <param name="Count">Number of views of a moment.</param>
internal sealed record RigView(RigCamera Camera, int Count)
{
    /// <summary>The moment of a frame.</summary>
    public int MomentOf(int frame) => frame / Count;
}
