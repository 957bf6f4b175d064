using System;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Where a harvest's frames go. No member may wait for a disk: they are called from the game's thread. A sink that can write no more
/// says so in <see cref="Fault"/> and takes no frames; the harvest then ends. Disposing waits until everything taken is written.
/// </summary>
public interface IFrameSink : IDisposable
{
    /// <summary>One line that says why no more can be written; null while all is well.</summary>
    string? Fault { get; }

    /// <summary>Number that the first frame gets: 0, or what follows the last one of a session that is continued.</summary>
    int FirstFrame { get; }

    /// <summary>Number that the first object gets: 1, or what follows the greatest one of a session that is continued.</summary>
    int FirstObjectId { get; }

    /// <summary>Begins the session; called once, before anything else.</summary>
    void Open(SessionStart start);

    /// <summary>Takes a frame. What is taken belongs to the sink, which disposes it when it is done with it.</summary>
    /// <returns>False when there is no room now; the frame then stays the caller's.</returns>
    bool TryEnqueue(CapturedFrame frame);

    /// <summary>Ends the session; no frame follows. Called once, if the session was opened.</summary>
    void Close(SessionEnd end);
}
