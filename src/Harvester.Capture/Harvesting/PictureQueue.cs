using Harvester.Capture.Labelling;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Labelled frames whose pictures another thread is still drawing, in their order. It holds few, so that memory stays bounded: the harvest
/// waits for the oldest picture before the queue grows further.
/// </summary>
/// <param name="capacity">Maximum number of frames that wait while the next ones are taken.</param>
internal sealed class PictureQueue(int capacity) : IDisposable
{
    /// <summary>
    /// The usual capacity: one whose picture is being drawn, and one behind it, so that the
    /// drawing thread always has work.
    /// </summary>
    public const int UsualCapacity = 2;

    private readonly Queue<(int Number, FrameDraft Frame)> _frames = new();

    /// <summary>Number of frames.</summary>
    public int Count => _frames.Count;

    /// <summary>The frames, the oldest first.</summary>
    public IEnumerable<FrameDraft> Frames => _frames.Select(static each => each.Frame);

    /// <summary>
    /// Whether the oldest frame is due: the queue is over its capacity, or the oldest picture was not deferred.
    /// </summary>
    public bool IsOldestDue => _frames.Count > capacity || (_frames.Count > 0 && !_frames.Peek().Frame.Picture!.IsDeferred);

    /// <summary>Adds a frame.</summary>
    /// <param name="number">Its number in the session.</param>
    /// <param name="frame">The frame, which belongs to the queue from now on.</param>
    public void Add(int number, FrameDraft frame) => _frames.Enqueue((number, frame));

    /// <summary>Removes the oldest frame, which belongs to the caller.</summary>
    public (int Number, FrameDraft Frame) Remove() => _frames.Dequeue();

    /// <summary>Drops all frames.</summary>
    public void Dispose()
    {
        while (_frames.Count > 0)
        {
            _frames.Dequeue().Frame.Picture!.Dispose();
        }
    }
}
