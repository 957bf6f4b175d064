using Harvester.Capture.Ports;

namespace Harvester.Driving.Session;

/// <summary>
/// Pauses and resumes the world, or runs it for one step, as the client requests. Without a request the world is left alone.
/// </summary>
/// <param name="pause">Freezes and resumes the game.</param>
/// <param name="settleTicks">Ticks after a pause until the image shows the paused world.</param>
/// <param name="isLockStep">Whether the world is paused at the beginning, and whenever no step is under way.</param>
internal sealed class WorldPace(IPause pause, int settleTicks, bool isLockStep)
{
    /// <summary>Tolerance at the end of a step, seconds, for a world whose time is a sum of rounded ticks.</summary>
    private const double Rounding = 1e-6;

    private double? _stepEndSeconds;
    private double _lastSeconds;
    private int _stillTicks;

    /// <summary>Whether the world is paused, or about to be.</summary>
    public bool IsPaused { get; private set; }

    /// <summary>Whether a step is under way.</summary>
    public bool IsStepping => _stepEndSeconds is not null;

    /// <summary>Whether the image shows the current state.</summary>
    public bool IsSettled => !IsPaused || _stillTicks >= settleTicks;

    public void Pause()
    {
        _stepEndSeconds = null;
        _stillTicks = 0;
        IsPaused = true;
        pause.Freeze();
    }

    /// <summary>Resumes the world, if it was paused here. In lock-step it only ends a step.</summary>
    public void GoOn()
    {
        if (isLockStep)
        {
            Pause();
        }
        else
        {
            Resume();
        }
    }

    /// <summary>Runs the world for a time and pauses it then.</summary>
    public void Step(double nowSeconds, double seconds)
    {
        Resume();
        _stepEndSeconds = nowSeconds + seconds - Rounding;
    }

    /// <summary>Does the work of one tick: pauses the world at the end of a step.</summary>
    public void Tick(double nowSeconds)
    {
        _stillTicks = IsPaused && nowSeconds == _lastSeconds ? _stillTicks + 1 : 0;
        _lastSeconds = nowSeconds;
        if (nowSeconds >= _stepEndSeconds || (isLockStep && !IsPaused && !IsStepping))
        {
            Pause();
        }
    }

    /// <summary>The world has been changed from outside: the image of a paused world shows it only later.</summary>
    public void Unsettle() => _stillTicks = 0;

    /// <summary>Gives the world back, as at the end of a drive.</summary>
    public void Resume()
    {
        _stepEndSeconds = null;
        if (IsPaused)
        {
            IsPaused = false;
            pause.Unfreeze();
        }
    }
}
