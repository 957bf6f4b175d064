using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Runs.Relabelling;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// Indicators with measured paint, and with the constant lane width, against the true lanes of roads whose widths and paint are drawn at
/// random. The seeds and places were not used to choose the method's constants.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class PaintedLanesTests(ITestOutputHelper output) : IDisposable
{
    /// <summary>The requirements of indicators: metres and radians.</summary>
    private const double MaxMetres = 0.05;
    private const double MaxRadians = 0.002;

    /// <summary>The share of errors that is to be as required where the lanes are measured, and smaller than without paint.</summary>
    private const double Most = 0.95;

    private const string Frames = "160";

    /// <summary>A distance that takes in a whole world, metres.</summary>
    private const double Everywhere = 1e6;

    private readonly TemporaryFolder _folder = new();
    private readonly LaneJudge _painted = new();
    private readonly LaneJudge _constant = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Indicators_follow_the_paint_of_random_towns()
    {
        foreach (int seed in TestSeeds.Or([235], [235, 236, 237]))
        {
            Judge(new SimulationOptions { Seed = seed, HasVariedRoads = true }, "--places", "6");
        }

        Required();
    }

    [RealWorldFact("nodes.zip")]
    public void Indicators_follow_the_paint_of_the_games_roads()
    {
        string roads = _folder.PathOf("roads.csv");
        CliRun.Of("roads", "import", RealWorldFactAttribute.PathOf("nodes.zip")!, "--out", roads).AssertDone();
        RoadNetwork network = RoadImporter.Import(roads).Network;
        Vector2D[] places = [new(0, -1000), new(2000, 3000), new(-700, 1000), new(-300, 6200)];
        foreach (Vector2D near in ProofSize.Of(places[..2], places))
        {
            var world = new SimulationOptions
            {
                Seed = 238,
                Roads = network,
                Near = near,
                HasVariedRoads = true,
            };
            Judge(world, "--roads", roads, FormattableString.Invariant($"--near={near.X},{near.Y}"), "--wander", "1");
        }

        Required();
    }

    /// <summary>The seeds of the test, or those of a variable of the environment while the method is developed.</summary>
    private void Judge(SimulationOptions world, params string[] options)
    {
        string session = _folder.PathOf("session");
        string painted = _folder.PathOf("painted");
        string table = _folder.PathOf("paint.csv");
        string seed = FormattableString.Invariant($"{world.Seed}");
        string[] harvest = ["harvest", "--out", session, "--overwrite", "--varied-roads", "--seed", seed, "--frames", Frames, "--hz", "2"];
        CliRun.Of([.. harvest, "--no-report", .. options]).AssertDone();
        string[] roads = world.Roads is null ? [] : ["--roads", _folder.PathOf("roads.csv")];
        CliRun.Of(["roads", "paint", session, "--out", table, .. roads]).AssertDone();
        string[] relabel = ["relabel", session, "--paint", table, "--out", painted, "--overwrite", "--no-report"];
        CliRun.Of([.. relabel, .. roads]).AssertDone();
        var game = new SimulatedGame(world);
        PaintedLine[] lines = [.. game.Ports.Paint!.Near(Vector3D.Zero, Everywhere)];
        PaintedLine[] measuredLines = [.. new PlacedPaint(PaintFile.Read(table, game.Roads)).Near(Vector3D.Zero, Everywhere)];
        _constant.Enter(game, lines, measuredLines);
        _painted.Enter(game, lines, measuredLines);
        IEnumerable<FrameLabel> labels = new SessionReader(painted).ReadLabels();
        foreach (((FrameLabel label, RecordedScene scene), FrameLabel measured) in RecordedSession.Open(new(session)).Frames().Zip(labels))
        {
            _constant.Judge(label, scene.Snapshot.Ego);
            _painted.Judge(measured, scene.Snapshot.Ego);
        }

        output.WriteLine($"constant: {_constant.Text(onlyPaint: false)}");
        output.WriteLine($"paint:    {_painted.Text(onlyPaint: false)}");
        output.WriteLine($"of these: {_painted.Text(onlyPaint: true)}");
        output.WriteLine($"outer edges: {_painted.Edges}");
    }

    private void Required()
    {
        _painted.Faults.ForEach(output.WriteLine);
        Assert.InRange(_painted.Metres(Most, onlyPaint: true), 0, MaxMetres);
        Assert.InRange(_painted.Angle(Most, onlyPaint: true), 0, MaxRadians);

        // Not the median: the lanes of single roads happen to be as wide as the constant.
        Assert.True(_painted.Metres(Most, onlyPaint: false) < _constant.Metres(Most, onlyPaint: false));
    }
}
