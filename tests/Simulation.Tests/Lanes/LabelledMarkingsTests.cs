using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Lanes;

/// <summary>
/// Painted markings as a harvest writes them against the paint in the picture. The text of each label is read as it is, and its points
/// are looked for in a finer picture of the same moment, in which the middle of a stripe two pixels wide can be determined.
/// </summary>
public sealed class LabelledMarkingsTests(ITestOutputHelper output)
{
    /// <summary>The required accuracy of markings from 5 to 50 m, pixels of the labels' image.</summary>
    private const double MaxErrorPixels = 1.5;

    /// <summary>
    /// Of the other points the paint is too thin to be measured, as that of the far lanes of wide roads, or something stands before it.
    /// </summary>
    private const double MinJudged = 1.0 / 3;

    [Theory]
    [InlineData(2)]
    [InlineData(4)]
    [InlineData(6)]
    [Trait("Category", "Heavy")]
    public void Labelled_markings_lie_on_the_paint_in_generated_towns(int seed) =>
        Assert.InRange(
            Judge(new SimulationOptions { Seed = seed, IsTimeOfDayFixed = true }, frames: 12, everySeconds: 7),
            150,
            int.MaxValue
        );

    [Fact]
    [Trait("Category", "Heavy")]
    public void Labelled_markings_lie_on_the_paint_of_a_winding_road()
    {
        var road = new SimulationOptions
        {
            Roads = Loop.Network(),
            RadiusMetres = 600,
            TrafficDensity = 0.2,
            PedestrianDensity = 0,
            IsTimeOfDayFixed = true,
        };
        Assert.InRange(Judge(road, frames: 8, everySeconds: 3), 150, int.MaxValue);
    }

    public static TheoryData<int> Towns => [.. ProofSize.Of([15], [3, 15, 17])];

    [Theory]
    [Trait("Category", "Heavy")]
    [MemberData(nameof(Towns))]
    public void Labelled_markings_lie_on_the_paint_all_over_generated_towns(int seed) =>
        Assert.InRange(
            Judge(new SimulationOptions { Seed = seed, IsTimeOfDayFixed = true }, frames: 30, everySeconds: 7),
            250,
            int.MaxValue
        );

    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void Labelled_markings_lie_on_the_paint_of_the_games_roads()
    {
        RoadNetwork network = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        Vector2D[] all = [new(0, -1000), new(2000, 3000), new(-700, 1000), new(-300, 6200)];
        Vector2D[] places = ProofSize.Of(all[..2], all);
        int judged = places.Sum(near =>
            Judge(
                new SimulationOptions
                {
                    Seed = 3,
                    Roads = network,
                    Near = near,
                    IsTimeOfDayFixed = true,
                },
                frames: 16,
                everySeconds: 7
            )
        );
        Assert.InRange(judged, ProofSize.Of(inCi: 150, full: 500), int.MaxValue);
    }

    private int Judge(SimulationOptions options, int frames, double everySeconds)
    {
        var game = new SimulatedGame(options);
        var judge = new MarkingJudge(game);
        using var session = new HarvestSession(
            new HarvestOptions
            {
                Image = MarkingJudge.Image,
                MaxFrames = frames,
                RateHz = 1 / everySeconds,
                RangeMetres = 10,
                MaxCalibrationErrorPixels = null,
            },
            game.Ports with
            {
                Roads = new FixedRoads(game.Roads, "simulation"),
            },
            judge
        );
        do
        {
            game.Tick(0.05);
            session.Step();
        } while (!session.Status.IsOver);

        output.WriteLine(judge.ToString());
        judge.Faults.ForEach(output.WriteLine);
        Assert.Null(session.Fault);
        Assert.Empty(judge.Faults);
        Assert.NotEqual(0, judge.Points);
        Assert.True(judge.Judged >= MinJudged * judge.Points, judge.ToString());
        Assert.InRange(judge.MaxError, 0, MaxErrorPixels);
        return judge.Judged;
    }
}
