namespace Harvester.Runs.Evaluation.Scores;

/// <summary>The distribution of scores over episodes, and their infractions per kilometre.</summary>
public sealed record DriveSummary
{
    /// <summary>Number of episodes.</summary>
    public required int Episodes { get; init; }

    /// <summary>Number of episodes that reached the time limit.</summary>
    public required int Timeouts { get; init; }

    /// <summary>Driving score, 0 to 100.</summary>
    public required MeanInterval DrivingScore { get; init; }

    /// <summary>Route completion, 0 to 1.</summary>
    public required MeanInterval RouteCompletionFraction { get; init; }

    /// <summary>
    /// Infractions per kilometre: lane departures per kilometre that the controller drove outside junctions, all others per kilometre
    /// driven.
    /// </summary>
    public required IReadOnlyList<EventRate> Rates { get; init; }

    /// <summary>Summarizes episodes; of none, all figures are 0.</summary>
    public static DriveSummary Of(IReadOnlyList<DriveEpisode> episodes)
    {
        ArgumentNullException.ThrowIfNull(episodes);
        double metres = episodes.Sum(episode => episode.Score.DrivenMetres);
        return new DriveSummary
        {
            Episodes = episodes.Count,
            Timeouts = episodes.Count(episode => episode.Ending == "time"),
            DrivingScore = Interval(score => score.DrivingScore),
            RouteCompletionFraction = Interval(score => score.RouteCompletionFraction),
            Rates =
            [
                Rate("vehicle collisions", score => score.Collisions.Vehicles),
                Rate("parked-vehicle collisions", score => score.Collisions.Parked),
                Rate("pedestrian collisions", score => score.Collisions.Pedestrians),
                Rate("red lights", score => score.RedLights),
                Rate("stop signs", score => score.StopSigns),
                Rate("stuck", score => score.Stuck),
                EventRate.Of(
                    "lane departures",
                    episodes.Sum(episode => episode.Figures.LaneDepartures),
                    episodes.Sum(episode => episode.Figures.JudgedMetres)
                ),
            ],
        };

        MeanInterval Interval(Func<EpisodeScore, double> value) =>
            episodes.Count == 0 ? MeanInterval.None : MeanInterval.Of([.. episodes.Select(episode => value(episode.Score))]);

        EventRate Rate(string name, Func<EpisodeScore, int> count) =>
            EventRate.Of(name, episodes.Sum(episode => count(episode.Score)), metres);
    }

    /// <summary>The figures as names and values with units, for display.</summary>
    public IEnumerable<(string Name, string Value)> Rows()
    {
        yield return ("driving score", Describe(DrivingScore, 1));
        yield return (
            "route completion",
            Describe(RouteCompletionFraction, 100) + (Timeouts > 0 ? FormattableString.Invariant($"; time limit reached: {Timeouts}") : "")
        );
        foreach (EventRate rate in Rates)
        {
            yield return (
                rate.Name,
                FormattableString.Invariant($"{rate.Events}")
                    + (
                        rate.PerKilometre is { } per
                            ? FormattableString.Invariant($", {per:0.###} per km (95 %: {rate.Low:0.###} to {rate.High:0.###})")
                            : ""
                    )
            );
        }
    }

    private string Describe(MeanInterval values, double scale)
    {
        string unit = scale == 1 ? "" : " %";
        return Episodes <= 1
            ? FormattableString.Invariant($"{scale * values.Mean:0.0}{unit}")
            : FormattableString.Invariant($"{scale * values.Mean:0.0}{unit} (95 %: {scale * values.Low:0.0} to ")
                + FormattableString.Invariant($"{scale * values.High:0.0}), ")
                + FormattableString.Invariant($"median {scale * values.Median:0.0}{unit}, {Episodes} episodes");
    }
}
