using Harvester.Sessions.Text;

namespace Harvester.Sessions.Events;

/// <summary>
/// How events are found, and which frames are kept around them. The thresholds of the kinds are fixed: docs/events.md names them.
/// </summary>
/// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
public sealed record EventOptions
{
    /// <summary>Least value of <see cref="KeepAroundSeconds"/>: for a second after its end, an event may still go on.</summary>
    public const double MinKeepSeconds = 1;

    /// <summary>Greatest value of <see cref="KeepAroundSeconds"/>: frames wait for so long.</summary>
    public const double MaxKeepSeconds = 60;

    /// <summary>
    /// Maximum readings per second of the game's time, greater than 0; a game that ticks more slowly is read in every tick.
    /// </summary>
    public double RateHz
    {
        get;
        init => field = OptionCheck.Positive(value, nameof(RateHz));
    } = 60;

    /// <summary>Distance from the ego up to which other road users are read, metres; greater than 0.</summary>
    public double RangeMetres
    {
        get;
        init => field = OptionCheck.Positive(value, nameof(RangeMetres));
    } = 100;

    /// <summary>
    /// Time before and after an event in which frames are kept, seconds, 1 to 60; the others are not written. Null (default) keeps all.
    /// </summary>
    public double? KeepAroundSeconds
    {
        get;
        init =>
            field =
                value is > MaxKeepSeconds
                    ? throw new ArgumentOutOfRangeException(nameof(KeepAroundSeconds), value, "It must be at most 60.")
                : value is { } seconds ? OptionCheck.AtLeast(seconds, MinKeepSeconds, nameof(KeepAroundSeconds))
                : null;
    }

    /// <summary>The kinds of events around which frames are kept; all by default.</summary>
    public IReadOnlyList<EventKind> KeepKinds { get; init; } = [.. typeof(EventKind).GetEnumValues().Cast<EventKind>()];
}
