namespace Harvester.Capture.Ports;

/// <summary>
/// The game's own display: head-up display, radar and messages. All calls come from the game's own thread; exceptions pass through.
/// </summary>
public interface IHud
{
    /// <summary>Whether the player's settings show the display, so that hiding it must change the picture; null if unknown.</summary>
    bool? IsWanted { get; }

    /// <summary>Hides the display in every picture from the next tick on. Calling it again has no effect.</summary>
    void Hide();

    /// <summary>
    /// Shows the display in every picture from the next tick on, even while pictures are taken, until it is hidden or given back.
    /// </summary>
    void Show();

    /// <summary>Gives the display back as it was before it was hidden. Calling it again has no effect.</summary>
    void Restore();
}
