using System.Globalization;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>The stretches of a place that are a scenario each: 91 steps of 0.1 s, one after another.</summary>
internal static class ScenarioWindow
{
    /// <summary>Time between steps, seconds.</summary>
    public const double Step = 0.1;

    /// <summary>Steps of a scenario; the last of a place may have fewer.</summary>
    public const int Steps = 91;

    /// <summary>The step that the readers call the present: what comes before it is the past, from which they predict.</summary>
    public const int Present = 10;

    /// <summary>A frame is that of a step if it is no farther from it than this, seconds: a car of 50 m/s moves 5 mm.</summary>
    public const double SameTime = 1e-4;

    /// <summary>Steps between two frames that are farther apart are not interpolated, seconds: at a rate of 1.5 frames a second there is
    /// just no gap.</summary>
    public const double MaxGap = 0.75;

    /// <summary>Number of the last scenario of a place.</summary>
    public const int Last = 9999;

    private const double Length = Step * Steps;

    /// <summary>Time of a step since the first frame of the place, seconds.</summary>
    public static double TimeOf(int window, int step) => ((window * Steps) + step) * Step;

    /// <summary>The scenario to which a frame belongs.</summary>
    /// <param name="seconds">Time since the first frame of the place, 0 or more.</param>
    /// <returns>Its number; null if the place lasts longer than scenarios can be numbered.</returns>
    public static int? Of(double seconds) => Math.Floor((seconds + SameTime) / Length) is var window && window <= Last ? (int)window : null;

    /// <summary>The scenarios with steps that a frame takes part in: its own, and the one before or after it.</summary>
    public static IEnumerable<int> WithStepsNear(double seconds)
    {
        int first = Math.Max(0, (int)Math.Floor((seconds - MaxGap) / Length));
        int last = Math.Min(Last, (int)Math.Floor((seconds + MaxGap) / Length));
        return Enumerable.Range(first, Math.Max(0, last - first + 1));
    }

    /// <summary>Whether a frame shows that its scenario has more than one step.</summary>
    public static bool HasSecondStep(double seconds, int window) => seconds >= TimeOf(window, 1) - SameTime;

    /// <summary>Name of a scenario.</summary>
    public static string Name(int sequence, int window) => string.Create(CultureInfo.InvariantCulture, $"{sequence:D4}_{window:D4}");
}
