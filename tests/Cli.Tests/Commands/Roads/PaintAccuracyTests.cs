using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// Measured paint against what is painted, on roads whose lane widths and paint are drawn at random. The seeds and places were not used to
/// choose the method's constants.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class PaintAccuracyTests(ITestOutputHelper output) : IDisposable
{
    private const string Frames = "160";

    /// <summary>A distance that takes in a whole world, metres.</summary>
    private const double Everywhere = 1e6;

    /// <summary>At least this length of road is needed to say that there is less than one false line in it, metres.</summary>
    private const double LongSample = 2000;

    private readonly TemporaryFolder _folder = new();
    private readonly PaintRecall _recall = new();

    /// <summary>Weather, time, detail and wear.</summary>
    public static TheoryData<string> Conditions =>
        [
            .. ProofSize.Of(
                ["rain 12:00 plain 0", "clear 12:00 full 0.6"],
                [
                    "rain 12:00 plain 0",
                    "clear 20:00 plain 0",
                    "overcast 12:00 plain 0",
                    "clear 12:00 full 0",
                    "clear 12:00 full 0.6",
                    "clear 12:00 plain 0.3",
                    "clear 12:00 plain 0.6",
                ]
            ),
        ];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Paint_of_random_towns_by_day_meets_the_requirements() =>
        PaintRequirements.AssertMet(Towns(ProofSize.Of([296], [296, 297, 298])), output);

    [RealWorldFact("nodes.zip")]
    public void Paint_of_random_roads_of_the_game_meets_the_requirements()
    {
        string roads = _folder.PathOf("roads.csv");
        CliRun.Of("roads", "import", RealWorldFactAttribute.PathOf("nodes.zip")!, "--out", roads).AssertDone();
        RoadNetwork network = RoadImporter.Import(roads).Network;
        PaintJudge? judge = null;
        Vector2D[] places = [new(-150, -900), new(1200, -1500), new(-1300, -400), new(1900, 3700)];
        foreach (Vector2D near in ProofSize.Of(places[..1], places))
        {
            var world = new SimulationOptions
            {
                Seed = 109,
                Roads = network,
                Near = near,
                HasVariedRoads = true,
            };
            string place = FormattableString.Invariant($"--near={near.X},{near.Y}");
            judge = Judged(world, judge, "--roads", roads, place, "--wander", "1");
        }

        PaintRequirements.AssertMet(judge!, output);
    }

    [Fact]
    public void False_lines_are_rare_over_two_kilometres()
    {
        PaintJudge judge = Towns(TestSeeds.Or([291, 292, 293, 294], [291, 292, 293, 294, 295]));

        Assert.InRange(judge.RoadMetres, LongSample, double.PositiveInfinity);
        PaintRequirements.AssertMet(judge, output);
    }

    [Theory]
    [MemberData(nameof(Conditions))]
    public void Paint_in_other_conditions_is_reported(string conditions)
    {
        string[] values = conditions.Split(' ');
        string[] options = ["--weather", values[0], "--time", values[1], "--detail", values[2], "--paint-wear", values[3]];
        PaintJudge judge = Towns(TestSeeds.Or([267], [267]), options);

        // Only figures are required of these, except that what is found is paint.
        Assert.InRange(judge.MedianError, 0, PaintRequirements.Max95);
    }

    private PaintJudge Towns(IEnumerable<int> seeds, params string[] options)
    {
        PaintJudge? judge = null;
        foreach (int seed in seeds)
        {
            judge = Judged(new SimulationOptions { Seed = seed, HasVariedRoads = true }, judge, [.. options, "--places", "6"]);
        }

        return judge!;
    }

    private PaintJudge Judged(SimulationOptions world, PaintJudge? judge, params string[] options)
    {
        string session = _folder.PathOf("session");
        string table = _folder.PathOf("paint.csv");
        string seed = FormattableString.Invariant($"{world.Seed}");
        string[] harvest = ["harvest", "--out", session, "--overwrite", "--varied-roads", "--seed", seed, "--frames", Frames, "--hz", "2"];
        CliRun.Of([.. harvest, "--no-report", .. options]).AssertDone();
        string[] roads = world.Roads is null ? [] : ["--roads", _folder.PathOf("roads.csv")];
        CliRun.Of(["roads", "paint", session, "--out", table, .. roads]).AssertDone();
        var game = new SimulatedGame(world);
        judge ??= new PaintJudge();
        PaintTable measured = PaintFile.Read(table, game.Roads);
        var curves = new RoadCurves(game.Roads);
        PaintedLine[] painted = [.. game.Ports.Paint!.Near(Vector3D.Zero, Everywhere)];
        judge.Judge(measured, curves, painted);
        Camera[] cameras = [.. new SessionReader(session).ReadLabels().Select(label => LabelCamera.Of(label.Camera))];
        _recall.Judge(measured, curves, painted, cameras);
        output.WriteLine(FormattableString.Invariant($"{judge}; of {_recall.VisibleMetres / 1000:0.00} km in view {_recall.Share:0.000}"));
        return judge;
    }
}
