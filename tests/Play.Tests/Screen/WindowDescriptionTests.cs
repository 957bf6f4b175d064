using Harvester.Play.Screen;
using Harvester.Play.Screen.Windows;

namespace Harvester.Play.Tests.Screen;

public sealed class WindowDescriptionTests
{
    private static readonly DesktopRectangle Left = new(-1920, 0, 0, 1080);
    private static readonly DesktopRectangle Right = new(0, 0, 2560, 1440);
    private static readonly DesktopRectangle Within = new(100, 130, 900, 730);
    private static readonly DesktopRectangle Framed = new(92, 100, 908, 738);

    public static TheoryData<string, bool> Cases => new() { { "borderless", false }, { "exclusive full screen", true } };

    [Theory]
    [MemberData(nameof(Cases))]
    public void Window_that_fills_a_monitor_is_borderless_or_full_screen(string mode, bool isExclusive)
    {
        Assert.Equal($"1920 x 1080, {mode}, 96 dpi", Describe(Left, Left, new DisplayFacts(96, isExclusive)));
        Assert.Equal($"2560 x 1440, {mode}, 144 dpi", Describe(Right, Right, new DisplayFacts(144, isExclusive)));
    }

    [Fact]
    public void Window_smaller_than_its_monitor_or_with_a_frame_is_windowed()
    {
        Assert.Equal("800 x 600, windowed, 120 dpi", Describe(Framed, Within, new DisplayFacts(120, false)));
        Assert.Equal("800 x 600, windowed", Describe(Within, Within, new DisplayFacts(null, true)));
    }

    [Fact]
    public void Minimised_window_has_no_size() =>
        Assert.Equal("minimised, 96 dpi", Describe(Framed, default, new DisplayFacts(96, false), isMinimised: true));

    [Fact]
    public void Hdr_is_named_only_if_windows_reports_it()
    {
        Assert.Equal("800 x 600, windowed, 96 dpi, HDR is on", Describe(Within, Within, new DisplayFacts(96, false) { IsHdr = true }));
        Assert.Equal("800 x 600, windowed, 96 dpi", Describe(Within, Within, new DisplayFacts(96, false) { IsHdr = false }));
    }

    [Fact]
    public void Screen_describes_its_window_or_its_absence()
    {
        var desktop = new ScriptedDesktop { Facts = new DisplayFacts(96, false) };
        using var screen = new GameWindowScreen(desktop, ScriptedDesktop.Process);
        using var other = new GameWindowScreen(desktop, ScriptedDesktop.Process + 1);

        Assert.Equal("80 x 60, windowed, 96 dpi", screen.Describe());
        Assert.Equal("no window", other.Describe());
    }

    private static string Describe(DesktopRectangle bounds, DesktopRectangle client, DisplayFacts facts, bool isMinimised = false)
    {
        var window = new TopLevelWindow(1, 7, IsApplication: true, isMinimised, ShowsNothing: false, bounds, client, client.Area);
        return WindowDescription.Of(new DesktopView([window], [Left, Right]), window, facts);
    }
}
