using Harvester.Capture.Harvesting;

namespace Harvester.Capture.Tests.Doubles;

/// <summary>Keeps a session's frames in memory.</summary>
internal sealed class MemorySink : IFrameSink
{
    public List<CapturedFrame> Frames { get; } = [];

    /// <summary>Whether frames are kept; otherwise their buffers go back at once.</summary>
    public bool KeepsFrames { get; init; } = true;

    /// <summary>Called with each frame.</summary>
    public Action<CapturedFrame> OnFrame { get; set; } = static _ => { };

    public SessionStart? Start { get; private set; }

    public SessionEnd? End { get; private set; }

    public bool HasRoom { get; set; } = true;

    public string? Fault { get; set; }

    public int FirstFrame { get; set; }

    public int FirstObjectId { get; set; } = 1;

    public int FirstEventId => 1;

    public void Open(SessionStart start) => Start = start;

    public bool TryEnqueue(CapturedFrame frame)
    {
        if (!HasRoom)
        {
            return false;
        }

        OnFrame(frame);
        if (KeepsFrames)
        {
            Frames.Add(frame);
        }
        else
        {
            frame.Dispose();
        }

        return true;
    }

    public void Close(SessionEnd end) => End = end;

    public void Dispose() { }
}
