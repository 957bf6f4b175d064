using Harvester.Capture.Events;
using Harvester.Sessions.Events;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Holds frames back until it is known whether an event is near them in time, and drops the others. What is kept follows from the game's
/// times alone.
/// </summary>
/// <param name="seconds">Time before and after an event in which frames are kept, seconds.</param>
/// <param name="kinds">The kinds of events that count.</param>
internal sealed class FrameKeeper(double seconds, IReadOnlyList<EventKind> kinds)
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
        while (_waiting.Count > 0)
        {
            double time = _waiting.Peek().Label.TimeSeconds;
            Forget(time);
            bool isNear = _events.Values.Any(span =>
                time >= span.BeginSeconds - seconds - TimeTolerance && time <= span.EndSeconds + seconds + TimeTolerance
            );
            if (isNear)
            {
                CapturedFrame kept = _waiting.Dequeue();
                kept.Bring(TakeCarried());
                return kept;
            }

            // An event may still begin so soon after the frame that it counts.
            if (!IsEnding && _newest < time + seconds - TimeTolerance)
            {
                return null;
            }

            CapturedFrame dropped = _waiting.Dequeue();
            _carried.AddRange(dropped.EndedEvents);
            dropped.Dispose();
            Dropped++;
        }

        return null;
    }

    /// <summary>Gives up the frames that wait; returns the events of these and of dropped ones that no kept frame brought.</summary>
    public IReadOnlyList<DrivingEvent> GiveUp()
    {
        while (_waiting.Count > 0)
        {
            CapturedFrame frame = _waiting.Dequeue();
            _carried.AddRange(frame.EndedEvents);
            frame.Dispose();
        }

        return TakeCarried();
    }

    private List<DrivingEvent> TakeCarried()
    {
        List<DrivingEvent> taken = [.. _carried];
        _carried.Clear();
        return taken;
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
