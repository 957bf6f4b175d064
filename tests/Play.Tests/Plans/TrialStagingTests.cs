using System.Text.Json.Nodes;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Play.Plans;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Scenarios;

namespace Harvester.Play.Tests.Plans;

/// <summary>Trials that stage scenarios in the game.</summary>
public sealed class TrialStagingTests : IDisposable
{
    private const string Plan = """
        {"name":"p","places":[{"name":"a","x":100,"y":190,"headingDegrees":270,"scenario":"s.json"}],"frames":50,"hz":2,
        "cameras":[{"name":"c","width":320,"height":240}]}
        """;

    private const string Scenario = """
        {"name":"small","kind":"leader","place":{"metres":60},"ego":{"speed":9},"end":{"seconds":4},
        "actors":[{"id":"a","type":"vehicle","model":"blista","start":{"metresAhead":50}},
        {"id":"b","type":"object","model":"cone","start":{"metresAhead":90}}],
        "events":[{"id":"stop","actor":"a","when":{"all":[{"distance":35,"actor":"a"}]},"do":{"action":"brake","acceleration":4}}]}
        """;

    /// <summary>More than all waits of an attempt together, in ticks of 50 ms.</summary>
    private const int MaxTicks = 10_000;

    private readonly string _root = Directory.CreateTempSubdirectory("trial-staging").FullName;
    private readonly TrialWorld _world = new() { NetworkOfStage = Road() };

    public TrialStagingTests() => Background.Watch = new WaitingWatch();

    public void Dispose()
    {
        Background.Watch = null;
        Directory.Delete(_root, recursive: true);
    }

    [Fact]
    public void Scenario_is_played_while_frames_are_taken()
    {
        TrialRun run = Run(Scenario);
        UntilPhase(run, TrialPhase.Settling);

        // The lane towards the east lies half a lane to the south of the road's middle, 10 m from the place of the plan.
        Assert.Equal((100, 200 - (RoadGeometry.LaneWidth / 2), 270), Rounded(_world.Position.X, _world.Position.Y, _world.HeadingDegrees));
        Assert.Equal(["spawn blista 0", "spawn cone 0"], _world.Staged.Done);
        Assert.False(_world.IsDriving);
        Assert.Equal(150, _world.Staged.Actors.First().Ground.X, 0.01);

        UntilPhase(run, TrialPhase.Driving);
        Assert.True(_world.Staged.AppearsAfter < 0, "Frames waited for the actors.");
        Assert.Equal(["ego 9", "follow 1 9", "launch 0 9", "launch 1 9"], _world.Staged.Done.Skip(2));
        Assert.Equal(
            [new("scenario", "small"), new("scenarioKind", "leader"), new("scenarioSeed", "77")],
            _world.KeptOfScenario!.Settings.ToDictionary(setting => setting.Key, setting => setting.Value)
        );
        double began = _world.TimeSeconds;
        UntilOver(run);

        // The ego has driven with 10 m/s for 1.5 s when it is 35 m behind the actor, and the scenario ends after 4 s.
        Assert.Equal(["speed 1 0", "clear"], _world.Staged.Done.Skip(6));
        Assert.InRange(_world.TimeSeconds - began, 4, 4.2);
        Assert.Null(run.Ending!.Reason);
        Assert.InRange(run.Ending.Frames, 7, 9);
        Assert.Empty(_world.Staged.Actors);
        JsonNode record = JsonNode.Parse(_world.KeptOfScenario.Text())!;
        Assert.Equal("time", (string?)record["outcome"]);
        Assert.Equal(["a", "b"], record["actors"]!.AsArray().Select(actor => (string?)actor!["id"]));
        Assert.Equal([501, 502], record["actors"]!.AsArray().Select(actor => (int)actor!["handle"]!));
        Assert.InRange((double)record["events"]![0]!["seconds"]!, 1.4, 1.6);
    }

    [Fact]
    public void Scenario_that_cannot_happen_ends_the_attempt()
    {
        string wide = Scenario.Replace("\"metres\":60", "\"metres\":60,\"lanesLeft\":2", StringComparison.Ordinal);

        Assert.Equal("The scenario 'small' cannot happen here. 0 lanes are to the left of the ego's; 2 are needed.", ReasonOf(Run(wide)));
    }

    [Fact]
    public void Roads_that_are_not_known_end_the_attempt()
    {
        _world.NetworkOfStage = null;

        Assert.StartsWith("The roads around the place are not known", ReasonOf(Run(Scenario)), StringComparison.Ordinal);
    }

    [Fact]
    public void Actor_that_the_game_does_not_make_ends_the_attempt()
    {
        _world.Staged.Refused = "cone";

        Assert.Equal("The game did not make the actor 'b' of the scenario.", ReasonOf(Run(Scenario)));
    }

    [Fact]
    public void Actors_that_do_not_appear_end_the_attempt()
    {
        _world.Staged.AppearsAfter = int.MaxValue;

        Assert.Equal("The game did not make the actors of the scenario in time.", ReasonOf(Run(Scenario)));
        Assert.Equal("clear", _world.Staged.Done[^1]);
    }

    private static RoadNetwork Road() =>
        new(
            [
                new RoadNode(0, 0, new Vector3D(-200, 200, 30), "", RoadNodeFlags.None),
                new RoadNode(0, 1, new Vector3D(600, 200, 30), "", RoadNodeFlags.None),
            ],
            [new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None)]
        );

    private static (double X, double Y, double Heading) Rounded(double x, double y, double heading) =>
        (Math.Round(x, 2), Math.Round(y, 2), Math.Round(heading, 2));

    private TrialRun Run(string scenario)
    {
        Plan plan = PlanParser.Read(Plan).Plan!;
        Trial trial = TrialList.Of(plan, plan.Places)[0];
        ScenarioTemplate template = ScenarioParser.Read(scenario).Template!;
        return new TrialRun(_world.Surroundings, plan, trial, Path.Combine(_root, trial.Id), rig: null, (template, 77));
    }

    private void UntilPhase(TrialRun run, TrialPhase phase)
    {
        for (int i = 0; run.Phase != phase; i++)
        {
            Assert.True(i < MaxTicks && run.Phase != TrialPhase.Over, $"{phase} never comes: {run.Phase}, {run.Ending}");
            _world.Pass();
            run.Tick();
        }
    }

    private string? ReasonOf(TrialRun run)
    {
        UntilOver(run);
        return run.Ending!.Reason;
    }

    private void UntilOver(TrialRun run)
    {
        for (int i = 0; run.Ending is null; i++)
        {
            Assert.True(i < MaxTicks, $"The end never comes: {run.Phase}");
            _world.Pass();
            run.Tick();
        }
    }
}
