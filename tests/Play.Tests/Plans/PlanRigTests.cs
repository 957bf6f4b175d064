using Harvester.Play.Plans;

namespace Harvester.Play.Tests.Plans;

/// <summary>Plans whose camera has a rig.</summary>
public sealed class PlanRigTests : DrivenPlan
{
    private const string WithRig = """
        {"name":"two","places":[{"name":"a","x":0,"y":0,"headingDegrees":0}],"frames":3,"hz":2,
        "cameras":[{"name":"pair","rig":"rigs/pair.json"}]}
        """;

    [Fact]
    public void Trial_with_a_rig_takes_moments_with_all_its_cameras()
    {
        WriteRig("left");
        PlanFeature plan = Driving(WithRig);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal(["left", "right"], World.HarvestedWith!.Rig!.Cameras.Select(camera => camera.Name));
        Assert.Equal("""{"trial":"a_clear_1200_pair_001","state":"done","attempt":1,"frames":6}""", Assert.Single(StatusLines()));
    }

    [Fact]
    public void Changed_rig_of_a_plan_is_refused()
    {
        WriteRig("left");
        PlanFeature first = Driving(WithRig);
        first.Toggle();
        UntilOff(first);
        WriteRig("front");
        PlanFeature second = Driving(WithRig);
        second.Toggle();
        UntilOff(second);

        Assert.Contains("has results of another plan", Told[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Settings_that_do_not_suit_a_rig_are_told_at_once()
    {
        World.Freezes = false;
        WriteRig("left");
        PlanFeature plan = Driving(WithRig);
        plan.Toggle();
        UntilOff(plan);

        Assert.Contains("The plan cannot run: Rig needs Mode = Freeze", Assert.Single(Told), StringComparison.Ordinal);
        Assert.Empty(StatusLines());
    }

    private void WriteRig(string first)
    {
        Directory.CreateDirectory(Path.Combine(Root, "rigs"));
        File.WriteAllText(
            Path.Combine(Root, "rigs", "pair.json"),
            $$"""
            {"name":"pair","cameras":[
            {"name":"{{first}}","position":[0,2,1],"verticalFovDegrees":50,"width":64,"height":48},
            {"name":"right","position":[1,0,1],"yawDegrees":-90,"verticalFovDegrees":50,"width":64,"height":48}]}
            """
        );
    }
}
