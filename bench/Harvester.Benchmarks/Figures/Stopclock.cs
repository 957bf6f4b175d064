using System.Diagnostics;

namespace Harvester.Benchmarks.Figures;

/// <summary>Takes the time of short work: the best of several runs, as other programs only ever make it longer.</summary>
internal static class Stopclock
{
    private const int WarmingRuns = 3;
    private const int Runs = 12;

    /// <summary>The seconds that a piece of work takes once it is compiled.</summary>
    public static double BestSeconds(Action work)
    {
        double best = double.PositiveInfinity;
        for (int run = 0; run < WarmingRuns + Runs; run++)
        {
            long start = Stopwatch.GetTimestamp();
            work();
            double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
            best = run < WarmingRuns ? best : Math.Min(best, seconds);
        }

        return best;
    }
}
