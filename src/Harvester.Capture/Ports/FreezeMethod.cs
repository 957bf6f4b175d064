namespace Harvester.Capture.Ports;

/// <summary>How a game's world is frozen while the game keeps ticking and rendering.</summary>
public enum FreezeMethod
{
    /// <summary>The game is paused, without its menu: SET_GAME_PAUSED.</summary>
    Paused,

    /// <summary>The game's time runs at a scale of 0: SET_TIME_SCALE.</summary>
    TimeScale,
}
