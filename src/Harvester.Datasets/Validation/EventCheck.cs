using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Checks the events of a session: each by itself, and with the labels, which name the open ones. Labels are looked at in their order.
/// </summary>
internal sealed class EventCheck
{
    /// <summary>Events that are read at most; a recording of weeks has fewer.</summary>
    private const int MaxEvents = 200_000;

    /// <summary>Events that last at once at most; a street has fewer road users.</summary>
    private const int MaxAtOnce = 10_000;

    /// <summary>Times are written with six decimals, seconds.</summary>
    private const double TimeTolerance = 1e-6;

    /// <summary>Time after its end for which an event stays open, and the longest time between readings, seconds: docs/events.md.</summary>
    private const double HoldSeconds = 1;
    private const double LongestReading = 1;

    /// <summary>Name of the simulated game in a session's header.</summary>
    private const string SimulatedGame = "simulation";

    private readonly List<SessionProblem> _problems = [];
    private readonly PriorityQueue<DrivingEvent, double> _waiting = new();
    private readonly List<DrivingEvent> _near = [];
    private readonly Dictionary<int, (DrivingEvent Event, int Line)> _events = [];
    private readonly Dictionary<int, (int First, int Last)> _frames = [];
    private readonly HashSet<int> _marked = [];
    private readonly Dictionary<int, (ObjectClass Class, string Model)> _participants = [];
    private readonly bool _hasFile;
    private readonly bool _isClosed;
    private readonly EventSpeedCheck? _speeds;
    private double _lastTime = double.NegativeInfinity;
    private bool _isOrdered = true;

    /// <summary>Reads the events of a session.</summary>
    /// <param name="session">The session.</param>
    /// <param name="info">What its header says; null if it cannot be read.</param>
    public EventCheck(SessionReader session, SessionInfo? info)
    {
        // All events of a session are in the file if it was closed without a fault.
        _isClosed = info is { CapturedFrames: not null, Fault: null };
        try
        {
            _hasFile = File.Exists(session.PathOf(FramePaths.Events));
            Read(session);
        }
        catch (DatasetFormatException e)
        {
            _problems.Add(new SessionProblem(FramePaths.Events, null, e.Message));
        }

        _speeds = info?.Game == SimulatedGame ? new EventSpeedCheck(_events.Values.Select(each => each.Event)) : null;
    }

    /// <summary>What is wrong with an event by itself; null for nothing.</summary>
    public static string? FirstProblem(DrivingEvent happened) => ProblemsOf(happened).FirstOrDefault();

    /// <summary>What is wrong with the events of a label.</summary>
    public IEnumerable<string> Problems(FrameLabel label)
    {
        if (label.Events is null)
        {
            return _hasFile ? [$"events is missing, but the session has {FramePaths.Events}."] : [];
        }

        // A session resumed after a restart of the game has earlier times again, at which events cannot be told apart by their times.
        _isOrdered &= label.TimeSeconds >= _lastTime;
        _lastTime = label.TimeSeconds;
        IEnumerable<string> problems = MarkProblems(label);
        return _isOrdered && _isClosed ? problems.Concat(TimeProblems(label)).Concat(_speeds?.Problems(label) ?? []) : problems;
    }

    /// <summary>What is wrong with the events, once all labels were looked at.</summary>
    public IEnumerable<SessionProblem> EndProblems()
    {
        if (_isClosed && _isOrdered)
        {
            foreach ((DrivingEvent happened, int line) in _events.Values)
            {
                bool isSeen = _frames.TryGetValue(happened.Id, out (int First, int Last) frames);
                if (isSeen && (happened.FirstFrame > frames.First || happened.LastFrame < frames.Last || happened.FirstFrame is null))
                {
                    Add(line, $"the event lasts from frame {frames.First} to {frames.Last} by its times, but does not say so.");
                }
            }
        }

        return _problems.OrderBy(problem => problem.Line);
    }

    private void Read(SessionReader session)
    {
        foreach (EventLine line in session.ReadEventLines())
        {
            if (line.Number > MaxEvents)
            {
                Add(line.Number, $"more than {MaxEvents} events are not read.");
                break;
            }

            if (line.Event is not { } happened)
            {
                Add(line.Number, line.Problem!);
            }
            else if (!_events.TryAdd(happened.Id, (happened, line.Number)))
            {
                Add(line.Number, $"two events have the id {happened.Id}.");
            }
            else
            {
                foreach (string problem in ProblemsOf(happened).Concat(happened.Participants.Select(ChangeOf).OfType<string>()))
                {
                    Add(line.Number, problem);
                }

                _waiting.Enqueue(happened, happened.BeginSeconds);
            }
        }
    }

    private void Add(int line, string message) => _problems.Add(new SessionProblem(FramePaths.Events, line, message));

    private static IEnumerable<string> ProblemsOf(DrivingEvent happened)
    {
        if (happened.Id < 1)
        {
            yield return $"the id is {happened.Id}; ids begin at 1.";
        }

        if (
            happened.BeginSeconds < 0
            || happened.PeakSeconds < happened.BeginSeconds - TimeTolerance
            || happened.EndSeconds < happened.PeakSeconds - TimeTolerance
        )
        {
            yield return "beginSeconds, peakSeconds and endSeconds must be in this order, and 0 or more.";
        }

        if (
            happened.FirstFrame is null != happened.LastFrame is null
            || happened.FirstFrame > happened.LastFrame
            || happened.FirstFrame < 0
        )
        {
            yield return "firstFrame and lastFrame must be in this order, or both null.";
        }

        int expected = happened.Kind is EventKind.NearMiss or EventKind.Collision or EventKind.CutIn ? 2 : 1;
        if (happened.Participants.Count != expected)
        {
            yield return $"{JsonName.Of(happened.Kind)} has {expected} participants, not {happened.Participants.Count}.";
            yield break;
        }

        if (happened.Participants.Select(participant => participant.Object).Distinct().Count() != expected)
        {
            yield return "the participants are the same.";
        }

        foreach (EventParticipant participant in happened.Participants)
        {
            if (ProblemOf(participant) is { } problem)
            {
                yield return problem;
            }
        }

        foreach (string problem in EventPeakCheck.Problems(happened))
        {
            yield return problem;
        }
    }

    private static string? ProblemOf(EventParticipant participant)
    {
        Vector3D size = participant.ModelMax - participant.ModelMin;
        if (!(size.X > 0) || !(size.Y > 0) || !(size.Z > 0))
        {
            return "modelMin is not below modelMax.";
        }

        if (participant.Object is not { } id)
        {
            return participant.Class is null ? null : "the ego has a class.";
        }

        return id is < 1 or > ushort.MaxValue || participant.Class is null
            ? $"object is {id}; it must be 1 to {ushort.MaxValue}, and have a class."
            : null;
    }

    /// <summary>Notes who a participant is; returns what contradicts earlier events.</summary>
    private string? ChangeOf(EventParticipant participant) =>
        participant is { Object: { } id, Class: { } kind }
        && !_participants.TryAdd(id, (kind, participant.Model))
        && _participants[id] != (kind, participant.Model)
            ? $"object {id} is {JsonName.Of(kind)} '{participant.Model}', but another in an earlier event."
            : null;

    private IEnumerable<string> MarkProblems(FrameLabel label)
    {
        int last = 0;
        foreach (EventMark mark in label.Events!)
        {
            if (mark.Id <= last)
            {
                yield return "events are not by ascending ids.";
            }

            last = mark.Id;
            if (!_events.TryGetValue(mark.Id, out (DrivingEvent Event, int Line) known))
            {
                if (_isClosed)
                {
                    yield return $"event {mark.Id} is not in {FramePaths.Events}.";
                }
            }
            else if (known.Event.Kind != mark.Kind)
            {
                yield return $"event {mark.Id} is {JsonName.Of(mark.Kind)}, but {JsonName.Of(known.Event.Kind)} in {FramePaths.Events}.";
            }
            else if (
                _isOrdered
                && (
                    label.TimeSeconds < known.Event.BeginSeconds - TimeTolerance
                    || label.TimeSeconds > known.Event.EndSeconds + HoldSeconds + LongestReading
                )
            )
            {
                yield return $"event {mark.Id} is not open at the time of the frame.";
            }
        }

        foreach (ObjectLabel item in label.Objects)
        {
            if (_participants.TryGetValue(item.Id, out (ObjectClass Class, string Model) known) && known != (item.Class, item.Model))
            {
                yield return $"object {item.Id} is {JsonName.Of(item.Class)} '{item.Model}', but {JsonName.Of(known.Class)} "
                    + $"'{known.Model}' in {FramePaths.Events}.";
            }
        }
    }

    /// <summary>Compares the marks with the events that last at the time of the frame.</summary>
    private IEnumerable<string> TimeProblems(FrameLabel label)
    {
        while (_waiting.TryPeek(out DrivingEvent? next, out double begin) && begin <= label.TimeSeconds + TimeTolerance)
        {
            _near.Add(next);
            _waiting.Dequeue();
        }

        _near.RemoveAll(each => each.EndSeconds < label.TimeSeconds - TimeTolerance);
        if (_near.Count > MaxAtOnce)
        {
            _isOrdered = false;
            yield return $"more than {MaxAtOnce} events last at the time of the frame; events are not compared with later frames.";
            yield break;
        }

        _marked.Clear();
        _marked.UnionWith(label.Events!.Select(mark => mark.Id));
        foreach (DrivingEvent happened in _near)
        {
            _frames[happened.Id] = (_frames.TryGetValue(happened.Id, out var before) ? before.First : label.Frame, label.Frame);
            if (!_marked.Contains(happened.Id))
            {
                yield return $"event {happened.Id} lasts at the time of the frame, but is not among its events.";
            }
        }
    }
}
