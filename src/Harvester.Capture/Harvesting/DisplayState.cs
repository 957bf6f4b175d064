namespace Harvester.Capture.Harvesting;

/// <summary>What becomes of the game's own display in pictures of the frozen game.</summary>
public enum DisplayState
{
    /// <summary>It is in the picture if it is shown, and not if it is hidden.</summary>
    Hidden,

    /// <summary>The player's settings show it, and hiding it changes nothing: it may be in the pictures.</summary>
    Stays,

    /// <summary>Pictures with and without it are equal, as the player's settings show none or are unknown.</summary>
    NotSeen,
}
