using Harvester.Runs.Evaluation.Figures;
using Harvester.Runs.Evaluation.Scores;
using Harvester.Runs.Tests.Evaluation.Figures;

namespace Harvester.Runs.Tests.Evaluation.Scores;

public sealed class DriveSummaryTests
{
    /// <summary>The interval of 400 normal values changes by some hundredths with the draws and the resampling.</summary>
    private const double OfDraws = 0.12;

    [Fact]
    public void Counters_are_attributed_to_who_drove()
    {
        DriveSample[] samples =
        [
            Drives.At(0),
            Drives.At(1) with
            {
                Counters = new DriveCounters(1, 0, 0, 0, 0),
            },
            Drives.At(2) with
            {
                Counters = new DriveCounters(1, 2, 0, 1, 0),
                IsByController = false,
            },
            Drives.At(3) with
            {
                Counters = new DriveCounters(1, 2, 1, 1, 1),
            },
        ];
        EpisodeScore score = EpisodeScore.Of(samples, 6);

        Assert.Equal(new CollisionCounts(1, 2, 1), score.Collisions);
        Assert.Equal(new CollisionCounts(0, 2, 0), score.CollisionsOfBuiltInDriver);
        Assert.Equal((1, 1, 0.5), (score.RedLights, score.StopSigns, score.RouteCompletionFraction));
    }

    [Fact]
    public void Distance_outside_the_lanes_counts_as_a_share()
    {
        // A metre for each step, counted where it ends: two of four are outside.
        DriveSample[] samples = [Drives.At(0), Drives.At(1), Drives.At(2, lane: null), Drives.At(3, lane: null), Drives.At(4)];
        EpisodeScore score = EpisodeScore.Of(samples, 4);

        Assert.Equal((2, 0.5, 50), (score.OutsideMetres, score.PenaltyFraction, score.DrivingScore));
    }

    [Fact]
    public void Repositioning_counts_as_stuck_after_a_long_stand()
    {
        DriveSample[] stood = [.. Enumerable.Range(0, 150).Select(i => Drives.At(i) with { Speed = 0 })];
        DriveSample moved = Drives.At(150) with { IsTeleported = true };

        Assert.Equal(1, EpisodeScore.Of([.. stood, moved], 100).Stuck);
        Assert.Equal(0, EpisodeScore.Of([.. stood.Take(50), moved], 100).Stuck);
    }

    [Fact]
    public void Rates_count_departures_per_kilometre_that_is_judged()
    {
        DriveSample[] samples = Drives.Of(0, 2, 0, 0, 0);
        DriveSample[] builtIn = [.. samples.Select(sample => sample with { IsByController = false })];
        DriveSummary summary = DriveSummary.Of([new(1, null, samples, 10, isStopped: false), new(2, null, builtIn, 10, isStopped: true)]);

        // 1 departure; steps of √(1 + 4), √(1 + 4), 1 and 1 metres.
        EventRate departures = Assert.Single(summary.Rates, rate => rate.Name == "lane departures");
        Assert.Equal((1, 0.0065), (departures.Events, departures.Kilometres));
        Assert.Equal(1, summary.Timeouts);
    }

    [Fact]
    public void Interval_holds_the_mean_of_normal_values()
    {
        Random random = new(5);
        double[] values =
        [
            .. Enumerable
                .Range(0, 400)
                .Select(_ => 80 + (10 * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble()))),
        ];
        MeanInterval interval = MeanInterval.Of(values);

        // 1.96 · 10 / √400 = 0.98 on either side.
        Assert.Equal(0.98, interval.Mean - interval.Low, OfDraws);
        Assert.Equal(0.98, interval.High - interval.Mean, OfDraws);
        Assert.Equal(interval, MeanInterval.Of(values));
    }

    [Fact]
    public void Median_of_an_even_number_is_between_the_middle_two() =>
        Assert.Equal((4, 2.5), (MeanInterval.Of([10, 3, 2, 1]).Mean, MeanInterval.Of([10, 3, 2, 1]).Median));
}
