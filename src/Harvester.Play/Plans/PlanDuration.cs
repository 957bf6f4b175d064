using Harvester.Play.Features;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Text;

namespace Harvester.Play.Plans;

/// <summary>How long the trials of a plan that are left take.</summary>
internal static class PlanDuration
{
    private const double SecondsPerMinute = 60;

    /// <summary>One sentence for the player.</summary>
    /// <param name="folder">The plan and what is done.</param>
    /// <param name="pace">Real time for a second of game time in a harvest, seconds; null if it is not measured yet.</param>
    public static string Of(PlanFolder folder, double? pace)
    {
        Trial[] left = [.. folder.Left];
        double minutes = left.Sum(trial => folder.Plan.FramesAt(trial.Place)) / folder.Plan.Hz / SecondsPerMinute;
        string driving = FormattableString.Invariant(
            $"The plan has {Counted.Of(left.Length, "trial")} left, {minutes:0.#} minutes of driving. "
        );
        return pace is { } measured
            ? FormattableString.Invariant($"{driving}{PaceText.Of(measured)}, so that they take about {measured * minutes:0.#} minutes.")
            : driving + "How long a minute of driving takes is shown once it is measured.";
    }
}
