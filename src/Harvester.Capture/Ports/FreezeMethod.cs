namespace Harvester.Capture.Ports;

/// <summary>A way to make a game's world stand still while the game goes on ticking and rendering.</summary>
public enum FreezeMethod
{
    /// <summary>The game is paused, without its menu: SET_GAME_PAUSED.</summary>
    Paused,

    /// <summary>The game's time runs at a scale of 0: SET_TIME_SCALE.</summary>
    TimeScale,
}
