using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>A game's pause and its time, which stands still while the game is paused, whatever the game's own timer does.</summary>
/// <param name="setFrozen">Freezes or resumes the game's world by one method, while scripts keep running.</param>
/// <param name="timerMilliseconds">The game's own timer, milliseconds.</param>
public sealed class GameTime(Action<FreezeMethod, bool> setFrozen, Func<int> timerMilliseconds) : IPause
{
    private const double SecondsPerMillisecond = 0.001;
    private FreezeMethod? _frozenBy;
    private int _frozenAt;
    private int _lost;

    /// <inheritdoc/>
    public FreezeMethod Method { get; set; }

    /// <summary>The game's time, seconds.</summary>
    public double Seconds => (_frozenBy is null ? Running : _frozenAt) * SecondsPerMillisecond;

    private int Running => timerMilliseconds() - _lost;

    /// <inheritdoc/>
    public void Freeze()
    {
        if (_frozenBy is null)
        {
            _frozenAt = Running;
            _frozenBy = Method;
        }

        setFrozen(_frozenBy.Value, true);
    }

    /// <inheritdoc/>
    public void Unfreeze()
    {
        if (_frozenBy is { } method)
        {
            // First the game, even if something fails after it.
            setFrozen(method, false);
            _frozenBy = null;
            _lost += Running - _frozenAt;
        }
    }
}
