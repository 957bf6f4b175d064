using System.Diagnostics;

namespace Harvester.Benchmarks.Figures;

/// <summary>Takes the time of short work: the best of several runs, as other programs only ever make it longer.</summary>
internal static class Stopclock
{
    private const int MinRuns = 5;

    /// <summary>The runtime compiles hot code again in the background; this is how long that may take on a busy machine.</summary>
    private static readonly TimeSpan Warming = TimeSpan.FromSeconds(0.8);

    private static readonly TimeSpan Measuring = TimeSpan.FromSeconds(0.7);

    /// <summary>The seconds that a piece of work takes once it is compiled.</summary>
    public static double BestSeconds(Action work)
    {
        Best(work, Warming);
        return Best(work, Measuring);
    }

    private static double Best(Action work, TimeSpan duration)
    {
        double best = double.PositiveInfinity;
        long begin = Stopwatch.GetTimestamp();
        for (int run = 0; run < MinRuns || Stopwatch.GetElapsedTime(begin) < duration; run++)
        {
            long start = Stopwatch.GetTimestamp();
            work();
            best = Math.Min(best, Stopwatch.GetElapsedTime(start).TotalSeconds);
        }

        return best;
    }
}
