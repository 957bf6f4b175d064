using Harvester.Play.Screen.Windows;

namespace Harvester.Capture.Windows;

/// <summary>The window is grabbed pixel for pixel wherever it lies and whatever its frame.</summary>
internal static class PlacementCases
{
    public static IEnumerable<CaptureCase> All =>
        [
            new("a window without a frame, at odd position and size", () => Grab(new(37, 53, 401, 303), Native.Popup)),
            new("a window with caption and frame: its client area alone", () => Grab(new(141, 97, 533, 377), Native.OverlappedWindow)),
            new("a window in the screen's upper left corner", () => Grab(new(0, 0, 320, 240), Native.Popup)),
            new("a window that fills the screen", () => Grab(WholeScreen(), Native.Popup)),
            new("a narrow window: 3 x 201", () => Grab(new(777, 5, 3, 201), Native.Popup)),
            new("a window moved between grabs", Moved),
            new("a window that shows another picture", Changed),
            new("a window below another that lies beside it", Beside),
            new("a window in words: size, mode and scaling", Described),
        ];

    public static Area WholeScreen()
    {
        using var pixels = PhysicalThread.Enter();
        return new Area(0, 0, Native.GetSystemMetrics(0), Native.GetSystemMetrics(1));
    }

    private static void Grab(Area client, uint style)
    {
        using var window = new PatternWindow(client, Pattern.Distinct(1), style);
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Shows(window, screen);
        Expect.Shows(window, screen);
    }

    private static void Moved()
    {
        using var window = new PatternWindow(new(11, 13, 300, 200), Pattern.Distinct(2), Native.OverlappedWindow);
        using var screen = GameWindowScreen.OfThisProcess();
        foreach ((int left, int top) in new[] { (100, 100), (501, 77), (502, 78), (8, 333) })
        {
            window.Place(new(left, top, 300, 200));
            Expect.Shows(window, screen);
        }
    }

    private static void Changed()
    {
        using var window = new PatternWindow(new(60, 60, 256, 192), Pattern.Distinct(3));
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Shows(window, screen);
        window.Show(Pattern.Distinct(4));
        Expect.Shows(window, screen);
    }

    private static void Described()
    {
        using (var window = new PatternWindow(new(141, 97, 533, 377), Pattern.Distinct(7), Native.OverlappedWindow))
        using (var screen = GameWindowScreen.OfThisProcess())
        {
            Expect.Says($"533 x 377, windowed, {Native.GetDpiForSystem()} dpi", screen.Describe());
        }

        Area whole = WholeScreen();
        using (var window = new PatternWindow(whole, Pattern.Distinct(8)))
        using (var screen = GameWindowScreen.OfThisProcess())
        {
            Expect.Says($"{whole.Width} x {whole.Height}, borderless, {Native.GetDpiForSystem()} dpi", screen.Describe());
        }
    }

    private static void Beside()
    {
        using var window = new PatternWindow(new(100, 100, 300, 200), Pattern.Distinct(5));
        using var beside = new PatternWindow(new(400, 100, 100, 200), Pattern.Distinct(6));
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Shows(window, screen);
    }
}
