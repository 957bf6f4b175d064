namespace Harvester.Play.Screen;

/// <summary>The properties of a visible top-level window.</summary>
/// <param name="Handle">The window's handle.</param>
/// <param name="ProcessId">The process that it belongs to.</param>
/// <param name="IsApplication">Whether it can be an application's main window: no owner, no tool window, no console.</param>
/// <param name="IsMinimised">Whether it is minimised.</param>
/// <param name="ShowsNothing">Whether everything below it stays visible: it is cloaked, fully transparent, or a layer that lets clicks
/// through, as overlays are.</param>
/// <param name="Bounds">Its area on the desktop, without an invisible resizing border.</param>
/// <param name="Client">Its client area on the desktop; empty if minimised.</param>
/// <param name="RestoredArea">Its size in pixels when it is not minimised.</param>
internal sealed record TopLevelWindow(
    long Handle,
    int ProcessId,
    bool IsApplication,
    bool IsMinimised,
    bool ShowsNothing,
    DesktopRectangle Bounds,
    DesktopRectangle Client,
    long RestoredArea
);
