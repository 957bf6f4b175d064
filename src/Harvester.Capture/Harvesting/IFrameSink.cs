namespace Harvester.Capture.Harvesting;

/// <summary>
/// Receives a harvest's frames. No member may wait for a disk: they are called from the game's thread. A sink that can write no more says
/// so in <see cref="Fault"/> and accepts no frames; the harvest then ends. Disposing waits until everything accepted is written.
/// </summary>
public interface IFrameSink : IDisposable
{
    /// <summary>Why no more can be written, in one line; null if there is no fault.</summary>
    string? Fault { get; }

    /// <summary>Number of the first frame: 0, or the one after the last frame of a resumed session.</summary>
    int FirstFrame { get; }

    /// <summary>Number of the first object: 1, or the one after the greatest of a resumed session.</summary>
    int FirstObjectId { get; }

    /// <summary>Number of the first event: 1, or the one after the greatest of a resumed session.</summary>
    int FirstEventId { get; }

    /// <summary>Begins the session; called once, before anything else.</summary>
    void Open(SessionStart start);

    /// <summary>Offers a frame. An accepted frame belongs to the sink, which disposes it after writing.</summary>
    /// <returns>False if there is no room now; the frame then still belongs to the caller.</returns>
    bool TryEnqueue(CapturedFrame frame);

    /// <summary>Ends the session; no frame follows. Called once, if the session was opened.</summary>
    void Close(SessionEnd end);
}
