namespace Harvester.Play.Screen;

/// <summary>The window of the game.</summary>
public interface IGameWindow
{
    /// <summary>
    /// Size, mode and scaling of the window in one line for a log, such as "1920 x 1080, borderless, 96 dpi". It does not throw if there is
    /// no window.
    /// </summary>
    string Describe();
}
