using Harvester.Sessions.Imaging;

namespace Harvester.Play.Screen;

/// <summary>The desktop with the game's window. It only reads; decisions are made by its callers.</summary>
internal interface IDesktop
{
    /// <summary>Reads the current windows and monitors.</summary>
    DesktopView Observe();

    /// <summary>How a window is currently displayed.</summary>
    DisplayFacts FactsOf(long window);

    /// <summary>Copies a rectangle of the desktop.</summary>
    /// <param name="area">The rectangle; not empty.</param>
    /// <param name="target">Receives the pixels; of the rectangle's size.</param>
    /// <returns>Whether the desktop could be read: a locked session or a secure desktop cannot be.</returns>
    bool TryCopy(DesktopRectangle area, PixelBuffer target);
}
