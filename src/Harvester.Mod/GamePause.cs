using Harvester.Capture.Ports;

namespace Harvester.Mod;

/// <summary>Pauses the game under running scripts. Slow motion with a time scale of 0 would still creep.</summary>
internal sealed class GamePause : IPause
{
    private const double SecondsPerMillisecond = 0.001;
    private bool _isFrozen;
    private int _frozenAt;
    private int _lost;

    /// <summary>The game's time, which stands still while it is frozen, whatever the game's own timer does.</summary>
    public double TimeSeconds => (_isFrozen ? _frozenAt : Running) * SecondsPerMillisecond;

    private int Running => Natives.GameTimerMilliseconds() - _lost;

    /// <inheritdoc/>
    public void Freeze()
    {
        if (!_isFrozen)
        {
            _frozenAt = Running;
            _isFrozen = true;
        }

        Natives.SetPaused(true);
    }

    /// <inheritdoc/>
    public void Unfreeze()
    {
        // First the game, whatever fails after it.
        if (_isFrozen)
        {
            Natives.SetPaused(false);
            _isFrozen = false;
            _lost += Running - _frozenAt;
        }
    }
}
