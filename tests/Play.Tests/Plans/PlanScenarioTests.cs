using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Play.Plans;

namespace Harvester.Play.Tests.Plans;

/// <summary>Plans whose place has a scenario.</summary>
public sealed class PlanScenarioTests : DrivenPlan
{
    private const string WithScenario = """
        {"name":"two","places":[{"name":"a","x":0,"y":0,"headingDegrees":0,"scenario":"s.json"}],"frames":3,"hz":2,
        "cameras":[{"name":"c","width":64,"height":48}]}
        """;

    private const string Scenario = """
        {"name":"small","kind":"leader","end":{"seconds":9},"actors":[{"id":"a","type":"vehicle","start":{"metresAhead":50}}]}
        """;

    [Fact]
    public void Trial_stages_the_scenario_beside_the_plan()
    {
        World.NetworkOfStage = new RoadNetwork(
            [
                new RoadNode(0, 0, new Vector3D(0, -300, 30), "", RoadNodeFlags.None),
                new RoadNode(0, 1, new Vector3D(0, 300, 30), "", RoadNodeFlags.None),
            ],
            [new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None)]
        );
        Write(Scenario);
        PlanFeature plan = Driving(WithScenario);
        plan.Toggle();
        Background.Watch = new WaitingWatch();
        try
        {
            UntilOff(plan);
        }
        finally
        {
            Background.Watch = null;
        }

        Assert.Equal("""{"trial":"a_clear_1200_c_001","state":"done","attempt":1,"frames":3}""", Assert.Single(StatusLines()));
        Assert.Equal(["spawn car 0", "ego 10", "follow 1 10", "launch 0 10", "launch 1 10", "clear"], World.Staged.Done);
    }

    [Fact]
    public void Scenario_with_a_problem_is_told_at_once()
    {
        Write(Scenario.Replace("\"vehicle\"", "\"plane\"", StringComparison.Ordinal));
        PlanFeature plan = Driving(WithScenario);
        plan.Toggle();
        UntilOff(plan);

        Assert.Contains("the scenario s.json: ", Assert.Single(Told), StringComparison.Ordinal);
    }

    [Fact]
    public void Changed_scenario_of_a_plan_is_refused()
    {
        Write(Scenario);
        PlanFeature first = Driving(WithScenario);
        first.Toggle();
        UntilOff(first);
        Write(Scenario.Replace("50", "60", StringComparison.Ordinal));
        PlanFeature second = Driving(WithScenario);
        second.Toggle();
        UntilOff(second);

        Assert.Contains("has results of another plan", Told[^1], StringComparison.Ordinal);
    }

    private void Write(string scenario) => File.WriteAllText(Path.Combine(Root, "s.json"), scenario);
}
