using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>An event that has begun and is not yet known to be over.</summary>
/// <param name="id">Its number.</param>
/// <param name="kind">What happens.</param>
/// <param name="begin">The game's time of its first reading, seconds.</param>
/// <param name="users">Who takes part.</param>
internal sealed class OpenEvent(int id, EventKind kind, double begin, IReadOnlyList<RoadUser> users)
{
    /// <summary>Times closer than this, seconds, are equal.</summary>
    private const double TimeTolerance = 1e-6;

    private double _worst = double.PositiveInfinity;
    private double _peak = begin;
    private IReadOnlyList<EventParticipant> _participants = [.. users.Select(static user => user.Participant())];

    public EventMark Mark { get; } = new(id, kind);

    public double Begin { get; } = begin;

    public IReadOnlyList<RoadUser> Users => users;

    /// <summary>The game's time of the last reading in which its condition held, seconds.</summary>
    public double Last { get; private set; } = begin;

    /// <summary>Whether its condition has not held for so long that it is over.</summary>
    /// <param name="seconds">The game's time of the present reading, seconds.</param>
    public bool IsOverAt(double seconds) => seconds - Last >= EventRules.HoldSeconds - TimeTolerance;

    /// <summary>Measures that are known so far.</summary>
    public IReadOnlyList<KeyValuePair<string, double?>> Measures { get; set; } = [];

    /// <summary>Where and how hard the participants touched; null unless they collide.</summary>
    public EventContact? Contact { get; set; }

    /// <summary>Notes a reading in which the condition holds.</summary>
    /// <param name="seconds">The game's time, seconds.</param>
    /// <param name="badness">The less, the worse; the peak is the first of the worst readings.</param>
    /// <returns>Whether it is the worst reading so far.</returns>
    public bool Hold(double seconds, double badness)
    {
        Last = seconds;
        if (badness >= _worst)
        {
            return false;
        }

        _worst = badness;
        _peak = seconds;
        _participants = [.. users.Select(static user => user.Participant())];
        return true;
    }

    /// <summary>The event once it has ended.</summary>
    public DrivingEvent Ended(EventEnd end) =>
        new(Mark.Id, Mark.Kind, Begin, _peak, Last, end, _participants) { Measures = Measures, Contact = Contact };
}
