using Harvester.Capture.Surveys;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Runs.Harvesting;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// Paint measured in pictures from above, against what is painted, on roads whose lane widths and paint are drawn at random. The seeds and
/// places were not used to choose a constant.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class PaintFromAboveTests(ITestOutputHelper output) : IDisposable
{
    /// <summary>A distance that takes in a whole world, metres.</summary>
    private const double Everywhere = 1e6;

    /// <summary>Roads up to this distance are photographed, metres: some kilometres of roads, in minutes.</summary>
    private const double Range = 150;

    /// <summary>Paint up to this distance is to be found, metres: the survey's range without its border.</summary>
    private const double JudgedRange = Range - 20;

    /// <summary>Least share of a town's paint that is found: of ten metres, one may lie under trees, lamps and the motorway.</summary>
    private const double MinFound = 0.9;

    private const double WindowAspect = 16.0 / 9;

    /// <summary>"In nights" is more than one.</summary>
    private const double MaxNights = 2;
    private const double HoursOfNight = 8;

    private readonly TemporaryFolder _folder = new();
    private int _painted;
    private int _found;

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Paint_of_random_towns_meets_the_requirements()
    {
        PaintJudge judge = new();
        foreach (int seed in TestSeeds.Or([331], [331, 332, 333]))
        {
            Judge(new SimulationOptions { Seed = seed, HasVariedRoads = true }, judge);
        }

        PaintRequirements.AssertMet(judge, output);
        Assert.InRange((double)_found / _painted, MinFound, 1);
    }

    [RealWorldFact("nodes.zip")]
    public void Paint_of_roads_of_the_game_meets_the_requirements()
    {
        string roads = _folder.PathOf("roads.csv");
        CliRun.Of("roads", "import", RealWorldFactAttribute.PathOf("nodes.zip")!, "--out", roads).AssertDone();
        RoadNetwork network = RoadImporter.Import(roads).Network;
        PaintJudge judge = new();
        Vector2D[] places = [new(600, -400), new(1750, 3650)];
        foreach (Vector2D near in ProofSize.Of(places[..1], places))
        {
            var world = new SimulationOptions
            {
                Seed = 336,
                Roads = network,
                Near = near,
                HasVariedRoads = true,
            };
            Judge(world, judge, "--roads", roads, FormattableString.Invariant($"--near={near.X},{near.Y}"));
        }

        PaintRequirements.AssertMet(judge, output);
    }

    [RealWorldFact("nodes.zip")]
    public void Whole_map_is_photographed_in_nights()
    {
        RoadNetwork network = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        var view = new SurveyView(SurveyView.ImageFor(WindowAspect), Lens.Ideal, SurveyView.UsualMetresPerPixel);
        var plan = StationPlan.Of(new PaintRoads(new RoadCurves(network)), view.Footprint, null);
        double hours = plan.Stations.Count * SurveyDuration.UsualSecondsPerPicture / 3600;
        output.WriteLine(FormattableString.Invariant($"{plan.RoadMetres / 1000:0} km, {plan.Stations.Count} pictures, {hours:0.0} h"));

        Assert.InRange(hours, 0, MaxNights * HoursOfNight);
    }

    private void Judge(SimulationOptions world, PaintJudge judge, params string[] options)
    {
        string session = _folder.PathOf("session");
        string table = _folder.PathOf("paint.csv");
        string seed = FormattableString.Invariant($"{world.Seed}");
        CliRun photographed = CliRun.Of([
            .. new[] { "roads", "photograph", "--out", session, "--overwrite", "--varied-roads", "--seed", seed, $"--range={Range}" },
            .. options,
        ]);
        photographed.AssertDone();
        output.WriteLine(photographed.Out);
        string[] roads = world.Roads is null ? [] : ["--roads", _folder.PathOf("roads.csv")];
        CliRun.Of(["roads", "paint", session, "--out", table, .. roads]).AssertDone();
        var game = new SimulatedGame(world);
        PaintTable measured = PaintFile.Read(table, game.Roads);
        var curves = new RoadCurves(game.Roads);
        PaintedLine[] painted = [.. game.Ports.Paint!.Near(Vector3D.Zero, Everywhere)];
        judge.Judge(measured, curves, painted);
        var completeness = new PaintCompleteness(measured, curves);
        completeness.Judge(painted, world.Near ?? SimulatedSurvey.MiddleOf(game.Roads), JudgedRange);
        _painted += completeness.Painted;
        _found += completeness.Found;
        output.WriteLine($"{judge}; {_found} of {_painted} m of paint found");
    }
}
