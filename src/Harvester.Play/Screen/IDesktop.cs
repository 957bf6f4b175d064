using Harvester.Sessions.Imaging;

namespace Harvester.Play.Screen;

/// <summary>The desktop that a game's window lies on. Everything that decides anything lives outside of it.</summary>
internal interface IDesktop
{
    /// <summary>Windows and monitors as they are now.</summary>
    DesktopView Observe();

    /// <summary>How a window is displayed now.</summary>
    DisplayFacts FactsOf(long window);

    /// <summary>Copies what the monitors show of a rectangle.</summary>
    /// <param name="area">What to copy; not empty.</param>
    /// <param name="target">Where the pixels go; of the rectangle's size.</param>
    /// <returns>Whether the desktop could be read: a locked session or a secure desktop cannot.</returns>
    bool TryCopy(PixelRectangle area, PixelBuffer target);
}
