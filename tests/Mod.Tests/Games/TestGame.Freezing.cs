using GTA.Native;
using Harvester.Capture.Ports;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives that stop the world.</summary>
internal sealed partial class TestGame
{
    public bool IsPaused { get; private set; }

    public float TimeScale { get; private set; } = 1;

    /// <summary>Whether the world is frozen by either method.</summary>
    public bool IsFrozen => IsPaused || TimeScale == 0;

    /// <summary>Whether the game's window has the focus.</summary>
    public bool HasFocus { get; set; } = true;

    /// <summary>"Pause Game On Focus Loss", on in a new game: without the focus no script gets a tick.</summary>
    public bool PausesWithoutFocus { get; set; } = true;

    /// <summary>Whether frames pass and scripts get their ticks.</summary>
    public bool GivesTicks => HasFocus || !PausesWithoutFocus;

    /// <summary>The freeze method in which a camera keeps its position, however it is attached; null if there is none.</summary>
    public FreezeMethod? HoldsCamera { get; set; }

    /// <summary>The freeze method in which traffic continues; null if there is none.</summary>
    public FreezeMethod? LetsTrafficGoOn { get; set; }

    /// <summary>Whether this frame moves what drives.</summary>
    public bool DoesTrafficMove => !IsFrozen || FrozenBy == LetsTrafficGoOn;

    /// <summary>Called when the world is frozen or resumed, with the method.</summary>
    public Action<FreezeMethod, bool> FreezeChanged { get; set; } = (_, _) => { };

    private FreezeMethod? FrozenBy =>
        IsPaused ? FreezeMethod.Paused
        : TimeScale == 0 ? FreezeMethod.TimeScale
        : null;

    private bool IsCameraHeld => FrozenBy is { } method && method == HoldsCamera;

    private void AddFreezeNatives()
    {
        Do(
            Hash.SET_GAME_PAUSED,
            a =>
            {
                IsPaused = (bool)a[0];
                FreezeChanged(FreezeMethod.Paused, IsPaused);
            }
        );
        Do(
            Hash.SET_TIME_SCALE,
            a =>
            {
                TimeScale = (float)a[0];
                FreezeChanged(FreezeMethod.TimeScale, TimeScale == 0);
            }
        );
    }
}
