namespace Harvester.Play.Screen;

/// <summary>Describes how a game's window is displayed.</summary>
public static class WindowDescription
{
    /// <summary>A Direct3D program uses the whole monitor exclusively.</summary>
    public const string ExclusiveFullScreen = "exclusive full screen";

    /// <summary>A window without a frame that covers a monitor.</summary>
    public const string Borderless = "borderless";

    /// <summary>Any other window.</summary>
    public const string Windowed = "windowed";

    /// <summary>A monitor shows HDR, so that copies of the screen may be overexposed.</summary>
    public const string Hdr = "HDR is on";

    /// <summary>The description for a log.</summary>
    /// <param name="view">The desktop.</param>
    /// <param name="window">The game's window.</param>
    /// <param name="facts">How it is displayed.</param>
    internal static string Of(DesktopView view, TopLevelWindow window, DisplayFacts facts)
    {
        string dpi = (facts.Dpi is { } dots ? $", {dots} dpi" : string.Empty) + (facts.IsHdr == true ? $", {Hdr}" : string.Empty);
        return window.IsMinimised
            ? $"minimised{dpi}"
            : $"{window.Client.Width} x {window.Client.Height}, {ModeOf(view, window, facts)}{dpi}";
    }

    private static string ModeOf(DesktopView view, TopLevelWindow window, DisplayFacts facts)
    {
        bool fillsMonitor = window.Bounds == window.Client && view.Monitors.Contains(window.Client);
        return !fillsMonitor ? Windowed
            : facts.IsExclusive ? ExclusiveFullScreen
            : Borderless;
    }
}
