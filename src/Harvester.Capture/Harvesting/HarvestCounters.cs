using System;
using System.Collections.Generic;

namespace Harvester.Capture.Harvesting;

/// <summary>What a harvest has done so far.</summary>
public sealed class HarvestCounters
{
    private readonly SortedDictionary<string, int> _discards = new(StringComparer.Ordinal);
    private readonly SortedDictionary<int, int> _settleTicks = [];

    /// <summary>Frames handed to the sink, or left to other shards.</summary>
    public int Captured { get; internal set; }

    /// <summary>Frames begun and thrown away.</summary>
    public int Discarded { get; private set; }

    /// <summary>Ticks in which a frame was ready and the sink had no room.</summary>
    public int TicksWaitedForSink { get; internal set; }

    /// <summary>Frames thrown away, by reason, in the order of the reasons' letters.</summary>
    public IReadOnlyDictionary<string, int> Discards => _discards;

    /// <summary>How many frames needed how many ticks until everything stood still, by rising ticks.</summary>
    public IReadOnlyDictionary<int, int> SettleTicks => _settleTicks;

    internal void Discard(string reason)
    {
        Discarded++;
        _discards[reason] = (_discards.TryGetValue(reason, out int count) ? count : 0) + 1;
    }

    internal void Settled(int ticks) => _settleTicks[ticks] = (_settleTicks.TryGetValue(ticks, out int count) ? count : 0) + 1;
}
