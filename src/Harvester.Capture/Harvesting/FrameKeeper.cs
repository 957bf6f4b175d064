using Harvester.Capture.Events;
using Harvester.Sessions.Events;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Holds frames back until it is known whether an event is near them in time, and drops the others. What is kept follows from the game's
/// times alone.
/// </summary>
/// <param name="seconds">Time before and after an event in which frames are kept, seconds.</param>
/// <param name="kinds">The kinds of events that count.</param>
internal sealed class FrameKeeper(double seconds, IReadOnlyList<EventKind> kinds) : IDisposable
{
    /// <summary>Times closer than this, seconds, are equal: labels have six decimals.</summary>
    private const double TimeTolerance = 1e-6;

    private readonly Queue<CapturedFrame> _waiting = new();
    private readonly Dictionary<int, EventSpan> _events = [];
    private readonly List<DrivingEvent> _carried = [];
    private double _newest = double.NegativeInfinity;

    /// <summary>Whether no further frame follows, so that all are decided by what is known.</summary>
    public bool IsEnding { get; set; }

    /// <summary>Number of frames that were dropped.</summary>
    public int Dropped { get; private set; }

    /// <summary>Adds a frame, which belongs to the keeper from now on. Frames are added in their order.</summary>
    public void Add(CapturedFrame frame)
    {
        _waiting.Enqueue(frame);
        _newest = frame.Label.TimeSeconds;
        foreach (EventSpan span in frame.Events.Where(span => kinds.Contains(span.Kind)))
        {
            _events[span.Id] = span;
        }
    }

    /// <summary>Takes the next frame that is kept, which belongs to the caller; null if none is known yet.</summary>
    public CapturedFrame? Next()
    {
        while (_waiting.Count > 0 && (IsEnding || _newest >= _waiting.Peek().Label.TimeSeconds + seconds - TimeTolerance))
        {
            CapturedFrame frame = _waiting.Dequeue();
            double time = frame.Label.TimeSeconds;
            Forget(time);
            if (
                _events.Values.Any(span =>
                    time >= span.BeginSeconds - seconds - TimeTolerance && time <= span.EndSeconds + seconds + TimeTolerance
                )
            )
            {
                frame.Bring(TakeCarried());
                return frame;
            }

            _carried.AddRange(frame.EndedEvents);
            frame.Dispose();
            Dropped++;
        }

        return null;
    }

    /// <summary>Takes the events that ended before frames that were dropped and that no kept frame brought.</summary>
    public IReadOnlyList<DrivingEvent> TakeCarried()
    {
        List<DrivingEvent> taken = [.. _carried];
        _carried.Clear();
        return taken;
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        while (_waiting.Count > 0)
        {
            _waiting.Dequeue().Dispose();
        }
    }

    /// <summary>Forgets the events that are too long ago for a frame and all later ones.</summary>
    private void Forget(double time)
    {
        foreach (
            int id in _events.Values.Where(span => span.EndSeconds + seconds < time - TimeTolerance).Select(static span => span.Id).ToList()
        )
        {
            _events.Remove(id);
        }
    }
}
