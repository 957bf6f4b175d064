using System.Diagnostics;
using Harvester.Play.Screen.Windows;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Windows;

/// <summary>Grabs without end cost no memory and no handles.</summary>
internal static class CostCases
{
    private const int Grabs = 20;

    public static IEnumerable<CaptureCase> All =>
        [new("memory: a grab allocates the window list and no picture", Allocation), new("handles: GDI objects do not grow", Handles)];

    /// <summary>Milliseconds of a grab of a full HD window into a buffer.</summary>
    public static double MillisecondsPerGrab(int width, int height)
    {
        using var window = new PatternWindow(new(0, 0, 1920, 1080), Pattern.Distinct(1));
        using var screen = GameWindowScreen.OfThisProcess();
        var buffer = new PixelBuffer(new(width, height));
        window.AwaitOnScreen();
        GrabAll(screen, buffer);
        long start = Stopwatch.GetTimestamp();
        GrabAll(screen, buffer);
        return Stopwatch.GetElapsedTime(start).TotalMilliseconds / Grabs;
    }

    private static void Allocation()
    {
        // The facts of some windows and monitors, read twice; a picture of this window would be 230,400 bytes.
        const long maxBytesPerGrab = 20_000;
        using var window = new PatternWindow(new(10, 10, 320, 240), Pattern.Distinct(2));
        using var screen = GameWindowScreen.OfThisProcess();
        var buffer = new PixelBuffer(new(200, 150));
        window.AwaitOnScreen();
        GrabAll(screen, buffer);
        long before = GC.GetAllocatedBytesForCurrentThread();
        GrabAll(screen, buffer);
        long perGrab = (GC.GetAllocatedBytesForCurrentThread() - before) / Grabs;
        Expect.That(perGrab <= maxBytesPerGrab, $"{perGrab} bytes a grab");
    }

    private static void Handles()
    {
        using var window = new PatternWindow(new(10, 10, 320, 240), Pattern.Distinct(3));
        window.AwaitOnScreen();
        int before = GdiObjects();
        for (int size = 100; size < 100 + Grabs; size++)
        {
            window.Place(new(10, 10, size, 240));
            using var screen = GameWindowScreen.OfThisProcess();
            Expect.Shows(window, screen);
        }

        int after = GdiObjects();
        Expect.That(after <= before, $"{before} GDI objects before, {after} after {Grabs} screens");
    }

    private static int GdiObjects()
    {
        using var process = Process.GetCurrentProcess();
        return Native.GetGuiResources(process.Handle, 0);
    }

    private static void GrabAll(GameWindowScreen screen, PixelBuffer buffer)
    {
        for (int i = 0; i < Grabs; i++)
        {
            Expect.Good(screen.Grab(buffer));
        }
    }
}
