using Harvester.Play.Features;
using Harvester.Play.Plans;
using Harvester.Sessions.Plans;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Plans;

public sealed class PlanDrivingTests : IDisposable
{
    private const string TwoTrials = """
        {"name":"two","places":[{"name":"a","x":0,"y":0,"headingDegrees":0}],"weathers":["clear","rain"],"frames":3,"hz":2}
        """;

    private const string WithRig = """
        {"name":"two","places":[{"name":"a","x":0,"y":0,"headingDegrees":0}],"frames":3,"hz":2,
        "cameras":[{"name":"pair","rig":"rigs/pair.json"}]}
        """;

    private static readonly TimeSpan HangingAfter = TimeSpan.FromMinutes(1);
    private readonly string _root = Directory.CreateTempSubdirectory("plan-driving").FullName;
    private readonly List<string> _told = [];
    private readonly PlayerMessages _messages;
    private readonly TrialWorld _world = new();

    public PlanDrivingTests() => _messages = new PlayerMessages(_root, _told.Add, new TestClock());

    private string Output => Path.Combine(_root, "plans", "two");

    public void Dispose()
    {
        _messages.Wait(Timeout.InfiniteTimeSpan);
        Directory.Delete(_root, recursive: true);
    }

    [Fact]
    public void Key_runs_all_trials_in_order()
    {
        PlanDriving plan = Driving(TwoTrials);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal(
            [
                """{"trial":"a_clear_1200_camera_001","state":"done","attempt":1,"frames":3}""",
                """{"trial":"a_rain_1200_camera_001","state":"done","attempt":1,"frames":3}""",
            ],
            StatusLines());
        Assert.EndsWith($"The plan two is over: 2 trials done, none skipped, in {Output}.", _told[^1], StringComparison.Ordinal);
        Assert.Null(_world.Weather);
        Assert.Contains("\"state\":\"finished\"", Heartbeat(), StringComparison.Ordinal);
    }

    [Fact]
    public void Key_continues_after_the_trials_that_are_done()
    {
        PlanDriving first = Driving(TwoTrials);
        first.Toggle();
        Until(first, () => StatusLines().Length == 1 && first.Line is { } line && line.Contains("driving", StringComparison.Ordinal));
        first.Finish();
        Assert.False(first.IsOn);
        PlanDriving second = Driving(TwoTrials);
        second.Toggle();
        UntilOff(second);

        Assert.Equal(2, StatusLines().Length);
        Assert.Equal("""{"trial":"a_rain_1200_camera_001","state":"done","attempt":1,"frames":3}""", StatusLines()[1]);
        Assert.True(Directory.Exists(Path.Combine(Output, "unfinished", "a_rain_1200_camera_001")));
    }

    [Fact]
    public void Trial_that_fails_three_times_is_skipped_and_reported()
    {
        _world.IsCollisionLoaded = false;
        PlanDriving plan = Driving(TwoTrials);
        plan.Toggle();
        Until(plan, () => StatusLines().Length == 3);
        _world.IsCollisionLoaded = true;
        UntilOff(plan);

        Assert.Equal(
            [TrialState.Failed, TrialState.Failed, TrialState.Skipped, TrialState.Done],
            StatusLines().Select(line => TrialResult.Parse(line).State));
        Assert.Contains(_told, message => message.EndsWith(
            "attempt 3 of 3: The place did not load within 30 s. It is skipped.", StringComparison.Ordinal));
        Assert.Contains("1 trial done, skipped: a_clear_1200_camera_001, in", _told[^1], StringComparison.Ordinal);
        Assert.Contains("\"state\":\"incomplete\"", Heartbeat(), StringComparison.Ordinal);
    }

    [Fact]
    public void Trial_that_ends_the_game_three_times_is_skipped()
    {
        for (int end = 1; end <= 3; end++)
        {
            PlanDriving plan = Driving(TwoTrials);
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

        PlanDriving last = Driving(TwoTrials);
        last.Toggle();
        UntilOff(last);

        Assert.Equal(
            [TrialState.Failed, TrialState.Failed, TrialState.Skipped, TrialState.Done],
            StatusLines().Select(line => TrialResult.Parse(line).State));
        Assert.Contains(_told, message => message.EndsWith(
            "a_clear_1200_camera_001, attempt 3 of 3: The game ended during the attempt. It is skipped.", StringComparison.Ordinal));
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
        PlanDriving plan = Driving(TwoTrials);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal([TrialState.Done, TrialState.Done], StatusLines().Select(line => TrialResult.Parse(line).State));
    }

    [Fact]
    public void Low_space_stops_the_plan_and_uses_up_no_attempt()
    {
        PlanDriving plan = Driving(TwoTrials);
        plan.Toggle();
        Until(plan, () => _world.IsOn);
        _world.IsSpaceLow = true;
        _world.Break("The disk is nearly full.");
        UntilOff(plan);
        Assert.EndsWith("The plan was stopped: The disk is nearly full. The same key continues it.", _told[^1], StringComparison.Ordinal);
        Assert.Empty(StatusLines());

        (_world.IsSpaceLow, _world.Fault) = (false, null);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal([1, 1], StatusLines().Select(line => TrialResult.Parse(line).Attempt));
    }

    [Fact]
    public void Each_attempt_begins_with_a_repaired_vehicle()
    {
        PlanDriving plan = Driving(TwoTrials);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal([TrialWorld.Car, TrialWorld.Car], _world.Repaired);
    }

    [Fact]
    public void Plan_that_starts_by_itself_needs_no_key_and_starts_once()
    {
        string file = Path.Combine(_root, "plan.json");
        File.WriteAllText(file, TwoTrials);
        var plan = new PlanDriving(file, Path.Combine(_root, "plans"), _world.Surroundings, _messages) { StartsByItself = true };
        Until(plan, () => plan.IsOn);
        UntilOff(plan);
        int told = _told.Count;
        for (int tick = 0; tick < 100; tick++)
        {
            plan.Tick();
        }

        Assert.Equal(2, StatusLines().Length);
        Assert.Equal((false, told), (plan.IsOn, _told.Count));
    }

    [Fact]
    public void Second_press_stops_the_plan()
    {
        PlanDriving plan = Driving(TwoTrials);
        plan.Toggle();
        Until(plan, () => plan.Line is not null);
        plan.Toggle();

        Assert.False(plan.IsOn);
        Assert.EndsWith("The plan was stopped. The same key continues it.", _told[^1], StringComparison.Ordinal);
        Until(plan, () => !plan.IsBusy);
        Assert.Empty(StatusLines());
        Assert.Null(_world.Weather);
    }

    [Fact]
    public void Key_continues_after_an_error_of_the_disk()
    {
        string unfinished = Path.Combine(Output, "unfinished");
        Directory.CreateDirectory(Path.Combine(Output, "trials", "a_clear_1200_camera_001"));
        File.WriteAllText(unfinished, "a file where the folder belongs");
        PlanDriving plan = Driving(TwoTrials);
        plan.Toggle();
        UntilOff(plan);
        Assert.Contains("The plan was stopped: ", _told[^1], StringComparison.Ordinal);
        Assert.Empty(StatusLines());

        File.Delete(unfinished);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal([TrialState.Done, TrialState.Done], StatusLines().Select(line => TrialResult.Parse(line).State));
    }

    [Theory]
    [InlineData("""{"name":"p","places":[{"name":"a","spread":3}]}""",
        "plan.json: the place 'a' needs x and y, or a path: 'harvester plan resolve' chooses places for the game.")]
    [InlineData("""{"name":"p","places":[{"name":"a","x":1,"y":2}],"cameras":[{"name":"c","rig":"r.json"}]}""",
        "plan.json: the rig r.json of the camera 'c' cannot be used: ")]
    [InlineData("""{"name":"p","places":[{"name":"a","x":1,"y":2}],"weathers":["hot"]}""", "plan.json: weathers[0] must be one of")]
    public void Plan_that_the_game_cannot_run_is_told(string text, string problem)
    {
        PlanDriving plan = Driving(text);
        plan.Toggle();
        UntilOff(plan);

        Assert.Contains($"The plan cannot run: {problem}", Assert.Single(_told), StringComparison.Ordinal);
    }

    [Fact]
    public void Trial_with_a_rig_takes_moments_with_all_its_cameras()
    {
        WriteRig("left");
        PlanDriving plan = Driving(WithRig);
        plan.Toggle();
        UntilOff(plan);

        Assert.Equal(["left", "right"], _world.HarvestedWith!.Rig!.Cameras.Select(camera => camera.Name));
        Assert.Equal("""{"trial":"a_clear_1200_pair_001","state":"done","attempt":1,"frames":6}""", Assert.Single(StatusLines()));
    }

    [Fact]
    public void Changed_rig_of_a_plan_is_refused()
    {
        WriteRig("left");
        PlanDriving first = Driving(WithRig);
        first.Toggle();
        UntilOff(first);
        WriteRig("front");
        PlanDriving second = Driving(WithRig);
        second.Toggle();
        UntilOff(second);

        Assert.Contains("has results of another plan", _told[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Settings_that_do_not_suit_a_rig_are_told_at_once()
    {
        _world.Freezes = false;
        WriteRig("left");
        PlanDriving plan = Driving(WithRig);
        plan.Toggle();
        UntilOff(plan);

        Assert.Contains("The plan cannot run: Rig needs Mode = Freeze", Assert.Single(_told), StringComparison.Ordinal);
        Assert.Empty(StatusLines());
    }

    [Fact]
    public void Changed_plan_of_the_same_name_is_refused()
    {
        PlanDriving first = Driving(TwoTrials);
        first.Toggle();
        UntilOff(first);
        PlanDriving second = Driving(TwoTrials.Replace("\"frames\":3", "\"frames\":4", StringComparison.Ordinal));
        second.Toggle();
        UntilOff(second);

        Assert.Contains("has results of another plan", _told[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Key_without_a_plan_says_where_to_set_it()
    {
        var plan = new PlanDriving(null, _root, _world.Surroundings, _messages);
        plan.Toggle();

        Assert.False(plan.IsOn);
        Assert.EndsWith(
            "No plan is set. Give its file under [Plan] in GtaDataHarvester.ini.", Assert.Single(_told), StringComparison.Ordinal);
    }

    private PlanDriving Driving(string text)
    {
        string file = Path.Combine(_root, "plan.json");
        File.WriteAllText(file, text);
        return new PlanDriving(file, Path.Combine(_root, "plans"), _world.Surroundings, _messages);
    }

    private void WriteRig(string first)
    {
        Directory.CreateDirectory(Path.Combine(_root, "rigs"));
        File.WriteAllText(Path.Combine(_root, "rigs", "pair.json"), $$"""
            {"name":"pair","cameras":[
            {"name":"{{first}}","position":[0,2,1],"verticalFovDegrees":50,"width":64,"height":48},
            {"name":"right","position":[1,0,1],"yawDegrees":-90,"verticalFovDegrees":50,"width":64,"height":48}]}
            """);
    }

    private string[] StatusLines()
    {
        string path = Path.Combine(Output, "plan-status.jsonl");
        return File.Exists(path) ? File.ReadAllText(path).Split('\n', StringSplitOptions.RemoveEmptyEntries) : [];
    }

    private string Heartbeat()
    {
        string path = Path.Combine(Output, "heartbeat.json");
        string text = "";
        SpinWait.SpinUntil(
            () => File.Exists(path) && (text = File.ReadAllText(path)).Contains("\"trial\":null", StringComparison.Ordinal), HangingAfter);
        return text;
    }

    private void UntilOff(PlanDriving plan) => Until(plan, () => !plan.IsOn && !plan.IsBusy);

    private void Until(PlanDriving plan, Func<bool> isSo)
    {
        var hanging = System.Diagnostics.Stopwatch.StartNew();
        do
        {
            Assert.True(hanging.Elapsed < HangingAfter, string.Join('\n', _told));
            if (plan.IsBusy)
            {
                Thread.Sleep(1);
            }

            _world.Pass();
            plan.Tick();
        }
        while (!isSo());
    }
}
