using Harvester.Play.Screen.Windows;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Windows;

/// <summary>The picture is scaled to the size asked for; the thread's own awareness of scaling is left alone.</summary>
internal static class ScalingCases
{
    // Two roundings of the scaler, to 1/64 and to 1, and weights rounded to 1/16384.
    private const double RoundingTolerance = 0.6;

    public static IEnumerable<CaptureCase> All =>
        [
            new("shrunk by whole numbers: each pixel the mean of its block", () => Shrunk(new(32, 24, 800, 600), 4, 3)),
            new("shrunk from full HD to a third", () => Shrunk(new(0, 0, 1920, 1080), 3, 3)),
            new("enlarged twofold: every second pixel lies between its neighbours", Enlarged),
            new("the same buffer after a small one", SizesInTurn),
            new("the thread sees the desktop as it did before", Awareness),
        ];

    private static void Shrunk(Area client, int columns, int rows)
    {
        using var window = new PatternWindow(client, Pattern.Distinct(9));
        window.AwaitOnScreen();
        using var screen = GameWindowScreen.OfThisProcess();
        var buffer = new PixelBuffer(new(client.Width / columns, client.Height / rows));
        Expect.Good(screen.Grab(buffer));
        for (int y = 0, i = 0; y < buffer.Size.Height; y++)
        {
            for (int x = 0; x < buffer.Size.Width; x++)
            {
                for (int channel = 0; channel < PixelBuffer.BytesPerPixel; channel++, i++)
                {
                    double mean = Mean(window.Pattern, channel, x * columns, y * rows, columns, rows);
                    Expect.That(
                        Math.Abs(buffer.Bytes[i] - mean) <= RoundingTolerance,
                        $"pixel ({x}, {y}) channel {channel} is {buffer.Bytes[i]}, the mean is {mean}"
                    );
                }
            }
        }
    }

    private static double Mean(Pattern pattern, int channel, int left, int top, int columns, int rows)
    {
        double sum = 0;
        for (int y = top; y < top + rows; y++)
        {
            for (int x = left; x < left + columns; x++)
            {
                sum += pattern.Channel(channel, x, y);
            }
        }

        return sum / (columns * rows);
    }

    private static void Enlarged()
    {
        // Output column x lies at (x + 0.5) / 2 - 0.5: columns 1 and 2 a quarter and three quarters of the way from source 0 to 1.
        using var window = new PatternWindow(new(64, 64, 40, 30), new((x, _) => (byte)(x * 4), (_, y) => (byte)(y * 8), (_, _) => 0));
        window.AwaitOnScreen();
        using var screen = GameWindowScreen.OfThisProcess();
        var buffer = new PixelBuffer(new(80, 60));
        Expect.Good(screen.Grab(buffer));
        for (int x = 1; x < 79; x++)
        {
            int red = buffer.Bytes[((30 * 80) + x) * PixelBuffer.BytesPerPixel];
            Expect.That(Math.Abs(red - ((x * 2) - 1)) <= RoundingTolerance, $"column {x} is {red}, expected {(x * 2) - 1}");
        }
    }

    private static void SizesInTurn()
    {
        using var window = new PatternWindow(new(90, 70, 320, 240), Pattern.Distinct(10));
        window.AwaitOnScreen();
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Good(screen.Grab(new(new(80, 60))));
        Expect.Shows(window, screen);
        Expect.Good(screen.Grab(new(new(640, 480))));
        Expect.Shows(window, screen);
    }

    private static void Awareness()
    {
        using var window = new PatternWindow(new(90, 70, 320, 240), Pattern.Distinct(11));
        using var screen = GameWindowScreen.OfThisProcess();
        IntPtr before = Native.GetThreadDpiAwarenessContext();
        Expect.Shows(window, screen);
        Expect.That(Native.GetThreadDpiAwarenessContext() == before, "the thread's awareness of scaling was changed");
    }
}
