using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Quirks;

/// <summary>The entities that the harvest hides: some ticks after it has asked, and not those that the game always shows.</summary>
internal sealed class LateHiding(int seed, GameQuirks quirks)
{
    /// <summary>A prime, so that neighbouring handles are independent of each other.</summary>
    private const int HandleStep = 7919;

    private readonly Queue<(int Ticks, IReadOnlyCollection<int> Entities)> _asked = [];
    private int _ticks;

    /// <summary>The handles of the entities that the pictures do not show.</summary>
    public IReadOnlyCollection<int> Current { get; private set; } = [];

    /// <summary>Asks for a change.</summary>
    public void Ask(IReadOnlyCollection<int> entities) =>
        _asked.Enqueue((_ticks + 1 + quirks.VisibilityDelayTicks, [.. entities.Where(CanBeHidden)]));

    /// <summary>Runs a tick.</summary>
    /// <returns>Whether a change took effect in it.</returns>
    public bool Tick()
    {
        _ticks++;
        bool isChanged = false;
        while (_asked.TryPeek(out (int Ticks, IReadOnlyCollection<int> Entities) next) && next.Ticks <= _ticks)
        {
            Current = _asked.Dequeue().Entities;
            isChanged = true;
        }

        return isChanged;
    }

    private bool CanBeHidden(int handle) =>
        new Random(unchecked((seed * 31) + (handle * HandleStep))).NextDouble() >= quirks.UnhideableFraction;
}
