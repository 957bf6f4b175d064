namespace Harvester.Play.Settings;

/// <summary>How the game is frozen for a frame, as the player sets it.</summary>
internal enum FreezeChoice
{
    /// <summary>By the game's pause.</summary>
    Paused,

    /// <summary>By a time scale of 0.</summary>
    TimeScale,

    /// <summary>Both are tried at the start of a harvest, and the better one is used.</summary>
    Auto,
}
