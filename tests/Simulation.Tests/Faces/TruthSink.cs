using Harvester.Capture.Harvesting;
using Harvester.Sessions.Labels;

namespace Harvester.Simulation.Tests.Faces;

/// <summary>Keeps each frame's label with the truth of its street, and then lets the game go on to the next street.</summary>
internal sealed class TruthSink(StreetOfFaces game) : IFrameSink
{
    public List<(FrameLabel Label, IReadOnlyList<TrueFace> Faces)> Frames { get; } = [];

    public string? Fault => null;

    public int FirstFrame => 0;

    public int FirstObjectId => 1;

    public int FirstEventId => 1;

    public void Open(SessionStart start) { }

    public bool TryEnqueue(CapturedFrame frame)
    {
        Frames.Add((frame.Label, [.. game.Faces]));
        frame.Dispose();
        game.Next();
        return true;
    }

    public void Close(SessionEnd end) { }

    public void Dispose() { }
}
