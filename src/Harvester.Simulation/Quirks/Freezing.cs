using Harvester.Capture.Ports;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Quirks;

/// <summary>How time passes in a game that is frozen and resumed, by either method, each with its quirks.</summary>
internal sealed class Freezing(int seed, GameQuirks quirks)
{
    /// <summary>Time scale of a creeping world: fast enough that traffic moves by centimetres per tick, too slow to be noticed.</summary>
    private const double CreepingScale = 0.1;

    /// <summary>Number of ticks for which a vehicle is hidden, and for which none is, when visibility changes.</summary>
    private const int VisibilityTicks = 8;

    private static readonly FreezeQuirks None = new();
    private readonly Random _random = new(seed);
    private FreezeQuirks _quirks = None;
    private int _creepTicksLeft;
    private int _ticks;

    public FreezeMethod Method { get; set; }

    public bool IsAsked { get; private set; }

    public bool IsStanding => IsAsked && _creepTicksLeft == 0 && !_quirks.NeverStands;

    /// <summary>Whether a change of the camera takes effect only when the game resumes.</summary>
    public bool HoldsCamera => _quirks.HoldsCamera;

    /// <summary>Whether rain and time of day continue although the world is frozen.</summary>
    public bool LetsWeatherGoOn => _quirks.LetsWeatherGoOn;

    /// <summary>Whether an existing vehicle is not shown.</summary>
    public bool HidesVehicle => _quirks.ChangesVisibility && _ticks / VisibilityTicks % 2 == 1;

    /// <summary>Number of ticks for which a freeze has been asked for; 0 while the world runs.</summary>
    public int FrozenTicks => IsAsked ? Math.Max(1, _ticks) : 0;

    public void Freeze()
    {
        if (!IsAsked)
        {
            IsAsked = true;
            _quirks = Method == FreezeMethod.Paused ? quirks.Paused : quirks.TimeScale;
            _creepTicksLeft = _random.Next(_quirks.CreepTicks + 1);
            _ticks = 0;
        }
    }

    public void Unfreeze()
    {
        IsAsked = false;
        _quirks = None;
    }

    /// <summary>Runs a tick.</summary>
    /// <returns>The speed of the world's time in it: 1 when it runs, 0 when it is frozen.</returns>
    public double TakeTick()
    {
        double scale =
            !IsAsked ? 1
            : IsStanding ? 0
            : CreepingScale;
        _creepTicksLeft -= IsAsked && _creepTicksLeft > 0 ? 1 : 0;
        _ticks++;
        return scale;
    }
}
