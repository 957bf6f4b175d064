using System;
using Harvester.Capture.Ports;

namespace Harvester.Capture.Playing;

/// <summary>A game's pause, and its time, which stands still while it is paused, whatever the game's own timer does.</summary>
/// <param name="setPaused">Pauses the game under running scripts, or lets it go on.</param>
/// <param name="timerMilliseconds">The game's own timer, milliseconds.</param>
public sealed class GameTime(Action<bool> setPaused, Func<int> timerMilliseconds) : IPause
{
    private const double SecondsPerMillisecond = 0.001;
    private bool _isFrozen;
    private int _frozenAt;
    private int _lost;

    /// <summary>The game's time, seconds.</summary>
    public double Seconds => (_isFrozen ? _frozenAt : Running) * SecondsPerMillisecond;

    private int Running => timerMilliseconds() - _lost;

    /// <inheritdoc/>
    public void Freeze()
    {
        if (!_isFrozen)
        {
            _frozenAt = Running;
            _isFrozen = true;
        }

        setPaused(true);
    }

    /// <inheritdoc/>
    public void Unfreeze()
    {
        // First the game, whatever fails after it.
        if (_isFrozen)
        {
            setPaused(false);
            _isFrozen = false;
            _lost += Running - _frozenAt;
        }
    }
}
