namespace Harvester.Simulation.Quirks;

/// <summary>Removes an entity right after it has been read, and brings it back some ticks later. One at a time is removed.</summary>
internal sealed class Vanishing(int seed, double fraction)
{
    private const int MaxTicks = 50;

    private readonly Random _random = new(seed);
    private long _backAt;

    /// <summary>The handle of the removed entity; 0 if there is none.</summary>
    public int Handle { get; private set; }

    /// <summary>Call it after a reading of these entities.</summary>
    /// <returns>Whether one of them was removed.</returns>
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

    /// <summary>Call it in every tick: the entity comes back when its time is over.</summary>
    public void Tick(long gameFrame) => Handle = gameFrame >= _backAt ? 0 : Handle;
}
