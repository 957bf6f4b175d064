using Harvester.Play.Screen;
using Harvester.Play.Screen.Windows;

namespace Harvester.Capture.Windows;

/// <summary>A picture that does not show the window whole is refused with its reason, and the next good one is taken.</summary>
internal static class RefusalCases
{
    private static readonly Area Client = new(200, 150, 400, 300);

    public static IEnumerable<CaptureCase> All =>
        [
            new("no window at all", NoWindow),
            new("hidden", () => Refused(GrabRefusals.NoWindow, window => window.Hide(), window => window.Restore())),
            new("minimised, then restored", () => Refused(GrabRefusals.Minimised, window => window.Minimise(), window => window.Restore())),
            new("off screen by a pixel at the left", () => MovedOff(new(-1, 150, 400, 300))),
            new("off screen by a pixel at the top", () => MovedOff(new(200, -1, 400, 300))),
            new("off screen by a pixel at the right", () => MovedOff(new(PlacementCases.WholeScreen().Width - 399, 150, 400, 300))),
            new("off screen by a pixel at the bottom", () => MovedOff(new(200, PlacementCases.WholeScreen().Height - 299, 400, 300))),
            new("wholly off screen", () => MovedOff(new(-2000, -2000, 400, 300))),
            new("covered in one pixel", () => Covered(new(599, 449, 100, 100), GrabRefusals.Covered)),
            new("covered wholly", () => Covered(new(150, 100, 500, 400), GrabRefusals.Covered)),
            new("covered in the middle by a tool window", () => Covered(new(300, 250, 50, 50), GrabRefusals.Covered, Native.ExToolWindow)),
            new("covered by a half transparent layer", () => Covered(new(300, 250, 50, 50), GrabRefusals.Covered, Native.ExLayered)),
            new(
                "not covered by a layer that lets clicks through",
                () => Covered(new(300, 250, 50, 50), null, Native.ExLayered | Native.ExTransparent)
            ),
            new("not covered any more when the other window is minimised, or the game raised", Uncovered),
            new("resized: refused once, then the new size", Resized),
            new("black", () => Content(Pattern.Uniform(0, 0, 0), GrabRefusals.Black)),
            new("one colour", () => Content(Pattern.Uniform(200, 0, 0), GrabRefusals.SingleColour)),
            new("a night with one lamp is a picture", () => Content(Pattern.Night(399, 299), null)),
        ];

    private static void NoWindow()
    {
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Refused(GrabRefusals.NoWindow, screen);
    }

    private static void Refused(string reason, Action<PatternWindow> spoil, Action<PatternWindow> restore)
    {
        using var window = new PatternWindow(Client, Pattern.Distinct(1));
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Shows(window, screen);
        spoil(window);
        Expect.Refused(reason, screen);
        restore(window);
        Expect.Shows(window, screen);
    }

    private static void MovedOff(Area place) =>
        Refused(GrabRefusals.OffScreen, window => window.Place(place), window => window.Place(Client));

    private static void Covered(Area cover, string? refusal, uint exStyle = 0)
    {
        using var window = new PatternWindow(Client, Pattern.Distinct(2));
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Shows(window, screen);
        using (var above = new PatternWindow(cover, Pattern.Distinct(3), Native.Popup, exStyle))
        {
            if (refusal is null)
            {
                Expect.Good(screen.Grab(new(new(64, 48))));
            }
            else
            {
                Expect.Refused(refusal, screen);
            }
        }

        window.Show(Pattern.Distinct(4));
        Expect.Shows(window, screen);
    }

    private static void Uncovered()
    {
        using var window = new PatternWindow(Client, Pattern.Distinct(2));
        using var screen = GameWindowScreen.OfThisProcess();
        using var other = new PatternWindow(new(250, 200, 200, 100), Pattern.Distinct(3));
        window.RaiseToTop();
        Expect.Shows(window, screen);
        other.RaiseToTop();
        Expect.Refused(GrabRefusals.Covered, screen);
        other.Minimise();
        window.Show(Pattern.Distinct(5));
        Expect.Shows(window, screen);
        other.Restore();
        other.RaiseToTop();
        Expect.Refused(GrabRefusals.Covered, screen);
        window.RaiseToTop();
        window.Show(Pattern.Distinct(6));
        Expect.Shows(window, screen);
    }

    private static void Resized()
    {
        using var window = new PatternWindow(Client, Pattern.Distinct(7), Native.OverlappedWindow);
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Shows(window, screen);
        window.Place(Client with { Width = 517 });
        Expect.Refused(GrabRefusals.Resized, screen);
        Expect.Shows(window, screen);
        window.Place(Client with { Height = 211 });
        Expect.Refused(GrabRefusals.Resized, screen);
        Expect.Shows(window, screen);
    }

    private static void Content(Pattern pattern, string? refusal)
    {
        // The screen behind the window is black, as some patterns are: only after another is it the window's own.
        using var window = new PatternWindow(Client, Pattern.Distinct(8));
        window.AwaitOnScreen();
        window.Show(pattern);
        window.AwaitOnScreen();
        using var screen = GameWindowScreen.OfThisProcess();
        if (refusal is null)
        {
            Expect.Shows(window, screen);
        }
        else
        {
            Expect.Refused(refusal, screen);
        }

        window.Show(Pattern.Distinct(8));
        Expect.Shows(window, screen);
    }
}
