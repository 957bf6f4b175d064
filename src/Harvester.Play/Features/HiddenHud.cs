using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>
/// Hides radar and head-up display for as long as a feature takes pictures: they are switched off, because hiding them for a frame may have
/// no effect while the game is paused, and hidden in each frame besides. They are switched on again as soon as no feature needs them
/// hidden, however it ended; if the game refuses, this tries again in every tick. What was off before stays off.
/// </summary>
/// <param name="hud">Switches radar and head-up display.</param>
/// <param name="display">Hides them for one frame.</param>
/// <param name="isNeeded">Whether a feature takes pictures.</param>
public sealed class HiddenHud(IHudSwitch hud, IDisplay display, Func<bool> isNeeded) : IHud, IFeature
{
    private bool _isAsked;
    private bool _isShown;
    private bool _isSwitchedOff;

    /// <inheritdoc/>
    public string Name => "Hiding the game's display";

    /// <inheritdoc/>
    public bool IsOn { get; private set; }

    /// <inheritdoc/>
    public bool? IsWanted => hud.IsWanted;

    /// <inheritdoc/>
    public void Hide() => (_isAsked, _isShown) = (true, false);

    /// <inheritdoc/>
    public void Show() => _isShown = true;

    /// <inheritdoc/>
    public void Restore() => (_isAsked, _isShown) = (false, false);

    /// <inheritdoc/>
    public void Tick()
    {
        bool isHidden = !_isShown && (_isAsked || isNeeded());
        if (isHidden && !IsOn && hud.IsWanted && hud.IsShown)
        {
            // Noted first: a fault in the call leaves a display that is switched on once too often, not one that stays off.
            _isSwitchedOff = true;
            hud.Switch(false);
        }

        IsOn = isHidden;
        if (isHidden)
        {
            display.HideGames();
        }
        else
        {
            SwitchOn();
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        Restore();
        IsOn = false;
        SwitchOn();
    }

    private void SwitchOn()
    {
        if (_isSwitchedOff)
        {
            hud.Switch(true);
            _isSwitchedOff = false;
        }
    }
}
