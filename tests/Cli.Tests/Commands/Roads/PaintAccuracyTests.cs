using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
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

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Paint_of_random_towns_by_day_meets_the_requirements() => PaintRequirements.AssertMet(Towns([101, 102, 103]), output);

    [RealWorldFact("nodes.zip")]
    public void Paint_of_random_roads_of_the_game_meets_the_requirements()
    {
        string roads = _folder.PathOf("roads.csv");
        CliRun.Of("roads", "import", RealWorldFactAttribute.PathOf("nodes.zip")!, "--out", roads).AssertDone();
        RoadNetwork network = RoadImporter.Import(roads).Network;
        PaintJudge? judge = null;
        foreach (Vector2D near in new Vector2D[] { new(-150, -900), new(1200, -1500), new(-1300, -400), new(1900, 3700) })
        {
            var world = new SimulationOptions
            {
                Seed = 104,
                Roads = network,
                Near = near,
                HasVariedRoads = true,
            };
            string place = FormattableString.Invariant($"--near={near.X},{near.Y}");
            judge = Judged(world, judge, "--roads", roads, place, "--wander", "1");
        }

        PaintRequirements.AssertMet(judge!, output);
    }

    [Theory]
    [InlineData("rain", "12:00")]
    [InlineData("clear", "20:00")]
    [InlineData("overcast", "12:00")]
    public void Paint_in_other_conditions_is_reported(string weather, string time)
    {
        PaintJudge judge = Towns(Seeds("105"), "--weather", weather, "--time", time);

        // Only figures are required of these, except that what is found is paint.
        Assert.InRange(judge.MedianError, 0, PaintRequirements.Max95);
    }

    private static int[] Seeds(string seeds) =>
        [.. (Environment.GetEnvironmentVariable("GTADATAHARVESTER_PAINT_SEEDS") ?? seeds).Split(',').Select(int.Parse)];

    private PaintJudge Towns(int[] seeds, params string[] options)
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
        judge.Judge(PaintFile.Read(table, game.Roads), new RoadCurves(game.Roads), game.Ports.Paint!.Near(Vector3D.Zero, Everywhere));
        output.WriteLine(judge.ToString());
        return judge;
    }
}
