namespace Harvester.Play.Screen;

/// <summary>Whether and where a game's window can be grabbed.</summary>
/// <param name="Window">The window that was found; 0 if none.</param>
/// <param name="Client">Its client area on the desktop, when it can be grabbed.</param>
/// <param name="Refusal">One of <see cref="GrabRefusals"/>; null when it can be grabbed.</param>
internal readonly record struct WindowVerdict(long Window, PixelRectangle Client, string? Refusal);
