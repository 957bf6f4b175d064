using Harvester.Driving.Controllers;
using Harvester.Runs.Driving;
using Harvester.Runs.Evaluation.Noise;
using Harvester.Runs.Evaluation.Scores;

namespace Harvester.Cli.Tests.Driving;

/// <summary>Drives in towns that no constant was chosen for, as those of docs/driving.md.</summary>
[Trait("Category", "Heavy")]
public sealed class UnseenTownTests
{
    /// <summary>
    /// Limit for noisy indicators: published are far fewer departures per kilometre; in three kilometres, a single one is about 0.4.
    /// </summary>
    private const double MaxDeparturesPerKilometre = 1;

    private static readonly int[] NumbersOfJobs = [1, 3];

    [Theory]
    [InlineData(ControllerKind.Stanley)]
    [InlineData(ControllerKind.DeepDriving)]
    public void Few_departures_per_kilometre_in_unseen_towns(ControllerKind kind)
    {
        var drives = new EpisodeRunner(PlanOf(kind, metres: 1000, jobs: 2), TextWriter.Null);
        drives.Run(static _ => { }, CancellationToken.None);
        DriveSummary summary = DriveSummary.Of(drives.Episodes);

        EventRate departures = Assert.Single(summary.Rates, rate => rate.Name == "lane departures");
        Assert.True(departures.Kilometres > 1.5, $"Only {departures.Kilometres} km were judged.");
        Assert.InRange(departures.PerKilometre!.Value, 0, MaxDeparturesPerKilometre);
        Assert.All(["red lights", "stop signs"], name => Assert.Equal(0, Assert.Single(summary.Rates, rate => rate.Name == name).Events));
    }

    [Fact]
    public void Episodes_at_the_same_time_are_those_in_turn()
    {
        byte[][] records =
        [
            .. NumbersOfJobs.Select(jobs =>
            {
                var drives = new EpisodeRunner(PlanOf(ControllerKind.Stanley, metres: 150, jobs), TextWriter.Null);
                drives.Run(static _ => { }, CancellationToken.None);
                using var stream = new MemoryStream();
                DriveRecord.Of(new Dictionary<string, string>(), drives.Episodes).Write(stream);
                return stream.ToArray();
            }),
        ];
        Assert.Equal(records[0], records[1]);
    }

    private static DriveSettings PlanOf(ControllerKind kind, double metres, int jobs) =>
        new()
        {
            Controller = new ControllerPlan { Kind = kind, BrakesInEmergency = kind == ControllerKind.DeepDriving },
            Seeds = [9201, 9202, 9203],
            Metres = metres,
            Seconds = 600,
            Noise = NoiseLevels.Published,
            Jobs = jobs,
        };
}
