namespace Harvester.Sessions.Events;

/// <summary>An event of a session, one line of events.jsonl. Fields, units and ranges: docs/events.md.</summary>
/// <param name="Id">Number of the event in the session, from 1, by the time at which it began.</param>
/// <param name="Kind">What happened.</param>
/// <param name="BeginSeconds">The game's time of the first reading in which it happened, seconds.</param>
/// <param name="PeakSeconds">The game's time of the reading in which it was worst, seconds.</param>
/// <param name="EndSeconds">The game's time of the last reading in which it happened, seconds.</param>
/// <param name="End">Why it ended.</param>
/// <param name="Participants">Who took part: of a cut-in, who cuts in first; otherwise the ego first.</param>
public sealed record DrivingEvent(
    int Id,
    EventKind Kind,
    double BeginSeconds,
    double PeakSeconds,
    double EndSeconds,
    EventEnd End,
    IReadOnlyList<EventParticipant> Participants
)
{
    /// <summary>Number of the first frame from begin to end; null if no frame was taken in that time.</summary>
    public int? FirstFrame { get; init; }

    /// <summary>Number of the last frame from begin to end; null if no frame was taken in that time.</summary>
    public int? LastFrame { get; init; }

    /// <summary>What was measured, by name, in the order of the file; null where a value is unknown or does not apply.</summary>
    public IReadOnlyList<KeyValuePair<string, double?>> Measures { get; init; } = [];

    /// <summary>Where and how hard the participants touched; null unless they collided.</summary>
    public EventContact? Contact { get; init; }

    /// <summary>A measure; null if it is unknown or the event has no such measure.</summary>
    public double? Measure(string name) => Measures.FirstOrDefault(measure => measure.Key == name).Value;
}
