namespace Harvester.Capture.Harvesting;

/// <summary>The counters of a harvest.</summary>
public sealed class HarvestCounters
{
    private readonly SortedDictionary<string, int> _discards = new(StringComparer.Ordinal);
    private readonly SortedDictionary<int, int> _settleTicks = [];

    /// <summary>Frames handed to the sink, or left to other shards.</summary>
    public int Captured { get; internal set; }

    /// <summary>Frames taken, or left to other shards. The images of the latest may still be drawn.</summary>
    public int Taken { get; internal set; }

    /// <summary>Frames begun and discarded.</summary>
    public int Discarded { get; private set; }

    /// <summary>Ticks in which a frame was ready and the sink had no room.</summary>
    public int TicksWaitedForSink { get; internal set; }

    /// <summary>Discarded frames by reason, in alphabetical order.</summary>
    public IReadOnlyDictionary<string, int> Discards => _discards;

    /// <summary>Number of frames by the ticks they needed until everything stood still, in ascending order.</summary>
    public IReadOnlyDictionary<int, int> SettleTicks => _settleTicks;

    internal void Discard(string reason)
    {
        Discarded++;
        _discards[reason] = (_discards.TryGetValue(reason, out int count) ? count : 0) + 1;
    }

    internal void Settled(int ticks) => _settleTicks[ticks] = (_settleTicks.TryGetValue(ticks, out int count) ? count : 0) + 1;
}
