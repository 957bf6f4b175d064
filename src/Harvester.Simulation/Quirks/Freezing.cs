using System;

namespace Harvester.Simulation.Quirks;

/// <summary>How time passes in a game that is frozen and let go: a frozen world may creep on for some ticks.</summary>
internal sealed class Freezing(int seed, int mostCreepTicks)
{
    /// <summary>Fast enough that traffic moves by centimetres a tick, too slow to be seen.</summary>
    private const double CreepingScale = 0.1;

    private readonly Random _random = new(seed);
    private int _creepTicksLeft;

    public bool IsAsked { get; private set; }

    public bool IsStanding => IsAsked && _creepTicksLeft == 0;

    public void Freeze()
    {
        if (!IsAsked)
        {
            IsAsked = true;
            _creepTicksLeft = _random.Next(mostCreepTicks + 1);
        }
    }

    public void Unfreeze() => IsAsked = false;

    /// <summary>Takes a tick.</summary>
    /// <returns>The speed of the world's time in it: 1 when it runs, 0 when it stands.</returns>
    public double TakeTick()
    {
        double scale = !IsAsked ? 1 : IsStanding ? 0 : CreepingScale;
        _creepTicksLeft -= IsAsked && _creepTicksLeft > 0 ? 1 : 0;
        return scale;
    }
}
