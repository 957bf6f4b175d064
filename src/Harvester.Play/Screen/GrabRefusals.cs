namespace Harvester.Play.Screen;

/// <summary>Why a grab of the game's window was refused: the values of <see cref="Capture.Ports.GrabResult.Refusal"/>.</summary>
public static class GrabRefusals
{
    /// <summary>The process has no visible main window with a client area.</summary>
    public const string NoWindow = "noWindow";

    /// <summary>The window is minimised.</summary>
    public const string Minimised = "minimised";

    /// <summary>Part of the client area is on no monitor.</summary>
    public const string OffScreen = "offScreen";

    /// <summary>Another window covers part of the client area.</summary>
    public const string Covered = "covered";

    /// <summary>
    /// The client area's size differs from that of the grab before, or changed meanwhile: the game may still show the old size.
    /// </summary>
    public const string Resized = "resized";

    /// <summary>The window was moved while it was grabbed.</summary>
    public const string Moved = "moved";

    /// <summary>The desktop cannot be read: the session is locked, or a secure desktop is shown.</summary>
    public const string Unreadable = "unreadable";

    /// <summary>Every pixel is black, as in exclusive full screen; run the game in a window or in borderless full screen.</summary>
    public const string Black = "black";

    /// <summary>All pixels have the same colour.</summary>
    public const string SingleColour = "singleColour";
}
