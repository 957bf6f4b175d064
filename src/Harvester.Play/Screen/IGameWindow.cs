namespace Harvester.Play.Screen;

/// <summary>The window that the game is shown in.</summary>
public interface IGameWindow
{
    /// <summary>
    /// Size, mode and scaling of the window in one line for a log, such as "1920 x 1080, borderless, 96 dpi". It never throws for want of a
    /// window.
    /// </summary>
    string Describe();
}
