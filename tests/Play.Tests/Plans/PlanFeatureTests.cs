using Harvester.Play.Plans;
using Harvester.Sessions.Plans;

namespace Harvester.Play.Tests.Plans;

public sealed class PlanFeatureTests : DrivenPlan
{
    private const string TwoTrials = """
        {"name":"two","places":[{"name":"a","x":0,"y":0,"headingDegrees":0}],"weathers":["clear","rain"],"frames":3,"hz":2}
        """;

    [Fact]
    public void Key_runs_all_trials_in_order()
    {
        PlanFeature plan = Driving(TwoTrials);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal(
            [
                """{"trial":"a_clear_1200_camera_001","state":"done","attempt":1,"frames":3}""",
                """{"trial":"a_rain_1200_camera_001","state":"done","attempt":1,"frames":3}""",
            ],
            StatusLines()
        );
        Assert.EndsWith($"The plan two is over: 2 trials done, none skipped, in {Output}.", Told[^1], StringComparison.Ordinal);
        Assert.Null(World.Weather);
        Assert.Contains("\"state\":\"finished\"", Heartbeat(), StringComparison.Ordinal);
    }

    [Fact]
    public void Key_continues_after_the_trials_that_are_done()
    {
        PlanFeature first = Driving(TwoTrials);
        first.Toggle();
        Until(first, () => StatusLines().Length == 1 && first.Line is { } line && line.Contains("driving", StringComparison.Ordinal));
        first.Finish();
        Assert.False(first.IsOn);
        PlanFeature second = Driving(TwoTrials);
        second.Toggle();
        UntilOff(second);

        Assert.Equal(2, StatusLines().Length);
        Assert.Equal("""{"trial":"a_rain_1200_camera_001","state":"done","attempt":1,"frames":3}""", StatusLines()[1]);
        Assert.True(Directory.Exists(Path.Combine(Output, "unfinished", "a_rain_1200_camera_001")));
    }

    [Fact]
    public void Trial_that_fails_three_times_is_skipped_and_reported()
    {
        World.IsCollisionLoaded = false;
        PlanFeature plan = Driving(TwoTrials);
        plan.Toggle();
        Until(plan, () => StatusLines().Length == 3);
        World.IsCollisionLoaded = true;
        UntilOff(plan);

        Assert.Equal(
            [TrialState.Failed, TrialState.Failed, TrialState.Skipped, TrialState.Done],
            StatusLines().Select(line => TrialResult.Parse(line).State)
        );
        Assert.Contains(
            Told,
            message => message.EndsWith("attempt 3 of 3: The place did not load within 30 s. It is skipped.", StringComparison.Ordinal)
        );
        Assert.Contains("1 trial done, skipped: a_clear_1200_camera_001, in", Told[^1], StringComparison.Ordinal);
        Assert.Contains("\"state\":\"incomplete\"", Heartbeat(), StringComparison.Ordinal);
    }

    [Fact]
    public void Trial_that_ends_the_game_three_times_is_skipped()
    {
        for (int end = 1; end <= 3; end++)
        {
            PlanFeature plan = Driving(TwoTrials);
            plan.Toggle();
            Until(plan, () => plan.Line is not null);

            // What remains when the game ends now: the file of the attempt, which a plan that is stopped in good order deletes.
            string attempt = File.ReadAllText(Path.Combine(Output, "attempt.json"));
            Assert.Equal($$"""{"trial":"a_clear_1200_camera_001","attempt":{{end}}}""" + "\n", attempt);
            plan.Finish();
            Until(plan, () => !plan.IsBusy);
            Assert.False(File.Exists(Path.Combine(Output, "attempt.json")));
            File.WriteAllText(Path.Combine(Output, "attempt.json"), attempt);
        }

        PlanFeature last = Driving(TwoTrials);
        last.Toggle();
        UntilOff(last);

        Assert.Equal(
            [TrialState.Failed, TrialState.Failed, TrialState.Skipped, TrialState.Done],
            StatusLines().Select(line => TrialResult.Parse(line).State)
        );
        Assert.Contains(
            Told,
            message =>
                message.EndsWith(
                    "a_clear_1200_camera_001, attempt 3 of 3: The game ended during the attempt. It is skipped.",
                    StringComparison.Ordinal
                )
        );
        Assert.False(Directory.Exists(Path.Combine(Output, "trials", "a_clear_1200_camera_001")));
        Assert.False(File.Exists(Path.Combine(Output, "attempt.json")));
    }

    [Theory]
    [InlineData("")]
    [InlineData("{\"trial\":\"other\",\"attempt\":1}")]
    [InlineData("{\"trial\":\"a_clear_1200_camera_001\",\"attempt\":2}")]
    public void File_of_another_attempt_is_ignored(string attempt)
    {
        Directory.CreateDirectory(Output);
        File.WriteAllText(Path.Combine(Output, "attempt.json"), attempt);
        PlanFeature plan = Driving(TwoTrials);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal([TrialState.Done, TrialState.Done], StatusLines().Select(line => TrialResult.Parse(line).State));
    }

    [Fact]
    public void Low_space_stops_the_plan_and_uses_up_no_attempt()
    {
        PlanFeature plan = Driving(TwoTrials);
        plan.Toggle();
        Until(plan, () => World.IsOn);
        World.IsSpaceLow = true;
        World.Break("The disk is nearly full.");
        UntilOff(plan);
        Assert.EndsWith("The plan was stopped: The disk is nearly full. The same key continues it.", Told[^1], StringComparison.Ordinal);
        Assert.Empty(StatusLines());

        (World.IsSpaceLow, World.Fault) = (false, null);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal([1, 1], StatusLines().Select(line => TrialResult.Parse(line).Attempt));
    }

    [Fact]
    public void Each_attempt_begins_with_a_repaired_vehicle()
    {
        PlanFeature plan = Driving(TwoTrials);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal([TrialWorld.Car, TrialWorld.Car], World.Repaired);
    }

    [Fact]
    public void Plan_that_starts_by_itself_needs_no_key_and_starts_once()
    {
        string file = Path.Combine(Root, "plan.json");
        File.WriteAllText(file, TwoTrials);
        var plan = new PlanFeature(file, Path.Combine(Root, "plans"), World.Surroundings, Messages) { StartsByItself = true };
        Until(plan, () => plan.IsOn);
        UntilOff(plan);
        int told = Told.Count;
        for (int tick = 0; tick < 100; tick++)
        {
            plan.Tick();
        }

        Assert.Equal(2, StatusLines().Length);
        Assert.Equal((false, told), (plan.IsOn, Told.Count));
    }

    [Fact]
    public void Second_press_stops_the_plan()
    {
        PlanFeature plan = Driving(TwoTrials);
        plan.Toggle();
        Until(plan, () => plan.Line is not null);
        plan.Toggle();

        Assert.False(plan.IsOn);
        Assert.EndsWith("The plan was stopped. The same key continues it.", Told[^1], StringComparison.Ordinal);
        Until(plan, () => !plan.IsBusy);
        Assert.Empty(StatusLines());
        Assert.Null(World.Weather);
    }

    [Fact]
    public void Key_continues_after_an_error_of_the_disk()
    {
        string unfinished = Path.Combine(Output, "unfinished");
        Directory.CreateDirectory(Path.Combine(Output, "trials", "a_clear_1200_camera_001"));
        File.WriteAllText(unfinished, "a file where the folder belongs");
        PlanFeature plan = Driving(TwoTrials);
        plan.Toggle();
        UntilOff(plan);
        Assert.Contains("The plan was stopped: ", Told[^1], StringComparison.Ordinal);
        Assert.Empty(StatusLines());

        File.Delete(unfinished);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal([TrialState.Done, TrialState.Done], StatusLines().Select(line => TrialResult.Parse(line).State));
    }

    [Theory]
    [InlineData(
        """{"name":"p","places":[{"name":"a","spread":3}]}""",
        "plan.json: the place 'a' needs x and y, or a path: 'harvester plan resolve' chooses places for the game."
    )]
    [InlineData(
        """{"name":"p","places":[{"name":"a","x":1,"y":2}],"cameras":[{"name":"c","rig":"r.json"}]}""",
        "plan.json: the rig r.json of the camera 'c' cannot be used: "
    )]
    [InlineData("""{"name":"p","places":[{"name":"a","x":1,"y":2}],"weathers":["hot"]}""", "plan.json: weathers[0] must be one of")]
    public void Plan_that_the_game_cannot_run_is_told(string text, string problem)
    {
        PlanFeature plan = Driving(text);
        plan.Toggle();
        UntilOff(plan);

        Assert.Contains($"The plan cannot run: {problem}", Assert.Single(Told), StringComparison.Ordinal);
    }

    [Fact]
    public void Changed_plan_of_the_same_name_is_refused()
    {
        PlanFeature first = Driving(TwoTrials);
        first.Toggle();
        UntilOff(first);
        PlanFeature second = Driving(TwoTrials.Replace("\"frames\":3", "\"frames\":4", StringComparison.Ordinal));
        second.Toggle();
        UntilOff(second);

        Assert.Contains("has results of another plan", Told[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Key_without_a_plan_says_where_to_set_it()
    {
        var plan = new PlanFeature(null, Root, World.Surroundings, Messages);
        plan.Toggle();

        Assert.False(plan.IsOn);
        Assert.EndsWith(
            "No plan is set. Give its file under [Plan] in GtaDataHarvester.ini.",
            Assert.Single(Told),
            StringComparison.Ordinal
        );
    }
}
