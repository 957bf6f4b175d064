using Harvester.Sessions.Text;

namespace Harvester.Sessions.Events;

/// <summary>
/// How events are found, and which frames are kept around them. The thresholds of the kinds are fixed: docs/events.md names them.
/// </summary>
/// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
public sealed record EventOptions
{
    /// <summary>Maximum readings per second of the game's time, greater than 0; a game that ticks more slowly is read in every tick.</summary>
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
}
