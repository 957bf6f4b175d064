namespace Harvester.Play.Screen;

/// <summary>Whether and where a game's window can be grabbed.</summary>
/// <param name="Window">The window found; 0 if there is none.</param>
/// <param name="Client">Its client area on the desktop, if it can be grabbed.</param>
/// <param name="Refusal">One of <see cref="GrabRefusals"/>; null if it can be grabbed.</param>
internal readonly record struct WindowVerdict(long Window, DesktopRectangle Client, string? Refusal);
