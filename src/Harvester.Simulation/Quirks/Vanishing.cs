using System;
using System.Collections.Generic;

namespace Harvester.Simulation.Quirks;

/// <summary>Lets an entity be gone right after it has been read, and brings it back some ticks later. One is gone at a time.</summary>
internal sealed class Vanishing(int seed, double fraction)
{
    private const int MaxTicks = 50;

    private readonly Random _random = new(seed);
    private long _backAt;

    /// <summary>The handle of the entity that is gone; 0 for none.</summary>
    public int Handle { get; private set; }

    /// <summary>Called after a reading of these entities.</summary>
    /// <returns>Whether one of them is gone now.</returns>
    public bool AfterReading(IReadOnlyList<int> handles, long gameFrame)
    {
        if (Handle != 0 || handles.Count == 0 || _random.NextDouble() >= fraction)
        {
            return false;
        }

        Handle = handles[_random.Next(handles.Count)];
        _backAt = gameFrame + 1 + _random.Next(MaxTicks);
        return true;
    }

    /// <summary>Called in every tick: the entity comes back when its time is over.</summary>
    public void Tick(long gameFrame) => Handle = gameFrame >= _backAt ? 0 : Handle;
}
