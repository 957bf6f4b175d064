namespace Harvester.Play.Screen;

/// <summary>The desktop at one moment.</summary>
/// <param name="Windows">The visible top-level windows, the topmost first.</param>
/// <param name="Monitors">The rectangle of each monitor on the desktop.</param>
internal sealed record DesktopView(IReadOnlyList<TopLevelWindow> Windows, IReadOnlyList<DesktopRectangle> Monitors);
