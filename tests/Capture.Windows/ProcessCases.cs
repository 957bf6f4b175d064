using System.Diagnostics;
using System.Globalization;
using Harvester.Play.Screen;
using Harvester.Play.Screen.Windows;

namespace Harvester.Capture.Windows;

/// <summary>The window is found by its process, not by what is in the foreground; the main one of several.</summary>
internal static class ProcessCases
{
    /// <summary>The first argument of a process that shows a window until its input ends.</summary>
    public const string ShowArgument = "show";

    private static readonly Area Shown = new(700, 120, 301, 203);

    public static IEnumerable<CaptureCase> All =>
        [
            new("another process's window, while a larger one of ours is in the foreground", OtherProcess),
            new("our window, while another process's lies above it elsewhere", OwnProcess),
            new("a process that does not exist", () => Expect.Refused(GrabRefusals.NoWindow, new GameWindowScreen(int.MaxValue))),
            new("the largest of the process's windows", Largest),
            new("the window once found, though a larger one opens", Kept),
            new("a minimised game is not mistaken for its smaller window", MinimisedMain),
        ];

    /// <summary>Shows a window until the input ends.</summary>
    public static void Show(int seed)
    {
        using var window = new PatternWindow(Shown, Pattern.Distinct(seed));
        Console.WriteLine("shown");
        var ended = Task.Run(() => Console.In.ReadToEnd());
        while (!ended.IsCompleted)
        {
            PatternWindow.Settle();
        }
    }

    private static void OtherProcess()
    {
        using var mine = new PatternWindow(new(10, 10, 600, 500), Pattern.Distinct(1));
        WithOther(
            21,
            processId =>
            {
                mine.BringToForeground();
                using var screen = new GameWindowScreen(processId);
                Expect.Shows(Shown, Pattern.Distinct(21), screen);
            }
        );
    }

    private static void OwnProcess()
    {
        using var mine = new PatternWindow(new(10, 10, 600, 500), Pattern.Distinct(2));
        WithOther(
            22,
            _ =>
            {
                using var screen = GameWindowScreen.OfThisProcess();
                Expect.Shows(mine, screen);
            }
        );
    }

    private static void WithOther(int seed, Action<int> run)
    {
        var start = new ProcessStartInfo(Environment.ProcessPath!, [ShowArgument, seed.ToString(CultureInfo.InvariantCulture)])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
        };
        using var other = Process.Start(start)!;
        try
        {
            Expect.That(other.StandardOutput.ReadLine() == "shown", "the other process shows no window");
            PatternWindow.Settle();
            run(other.Id);
        }
        finally
        {
            other.StandardInput.Close();
            other.WaitForExit();
        }
    }

    private static void Largest()
    {
        using var small = new PatternWindow(new(10, 10, 100, 80), Pattern.Distinct(3));
        using var large = new PatternWindow(new(150, 100, 400, 300), Pattern.Distinct(4));
        using var tool = new PatternWindow(new(600, 100, 500, 500), Pattern.Distinct(5), Native.Popup, Native.ExToolWindow);
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Shows(large, screen);
    }

    private static void Kept()
    {
        using var first = new PatternWindow(new(10, 10, 100, 80), Pattern.Distinct(3));
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Shows(first, screen);
        using var large = new PatternWindow(new(150, 100, 400, 300), Pattern.Distinct(4));
        Expect.Shows(first, screen);
    }

    private static void MinimisedMain()
    {
        using var game = new PatternWindow(new(150, 100, 400, 300), Pattern.Distinct(4));
        using var small = new PatternWindow(new(10, 10, 100, 80), Pattern.Distinct(3));
        game.Minimise();
        using var screen = GameWindowScreen.OfThisProcess();
        Expect.Refused(GrabRefusals.Minimised, screen);
    }
}
