using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>The events of a harvest: opens, holds and closes them.</summary>
/// <param name="firstId">Number of the first event.</param>
internal sealed class EventBook(int firstId)
{
    private readonly List<OpenEvent> _open = [];
    private readonly List<ClosedEvent> _closed = [];
    private int _nextId = firstId;

    /// <summary>The events that are open, in the order in which they began.</summary>
    public IReadOnlyList<OpenEvent> Open => _open;

    /// <summary>The events that are over and have not been taken, in the order in which that became known.</summary>
    public IReadOnlyList<ClosedEvent> Closed => _closed;

    /// <summary>The open event of a kind with these participants; null if there is none.</summary>
    public OpenEvent? Find(EventKind kind, params RoadUser[] users) =>
        _open.Find(each => each.Mark.Kind == kind && each.Users.SequenceEqual(users));

    /// <summary>Whether a road user takes part in an open event of a kind.</summary>
    public bool IsIn(EventKind kind, RoadUser user) => _open.Exists(each => each.Mark.Kind == kind && each.Users.Contains(user));

    /// <summary>The open event of a kind with these participants, which begins now if there was none.</summary>
    public OpenEvent FindOrBegin(EventKind kind, double seconds, params RoadUser[] users)
    {
        if (Find(kind, users) is { } known)
        {
            return known;
        }

        var begun = new OpenEvent(_nextId++, kind, seconds, users);
        _open.Add(begun);
        return begun;
    }

    /// <summary>Closes an event.</summary>
    public void Close(OpenEvent over, EventEnd end, double seconds)
    {
        _open.Remove(over);
        _closed.Add(new ClosedEvent(over.Ended(end), seconds));
    }

    /// <summary>Closes all events, or those of some.</summary>
    public void CloseAll(EventEnd end, double seconds, Func<OpenEvent, bool>? which = null)
    {
        foreach (OpenEvent each in _open.Where(which ?? (static _ => true)).ToList())
        {
            Close(each, end, seconds);
        }
    }

    /// <summary>Takes the closed events that meet a condition.</summary>
    public IReadOnlyList<ClosedEvent> Take(Predicate<ClosedEvent> which)
    {
        List<ClosedEvent> taken = _closed.FindAll(which);
        _closed.RemoveAll(which);
        return taken;
    }
}
