using System.Text.Json.Nodes;
using Harvester.Cli.Commands.Plans;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Datasets.Validation;
using Json.Schema;

namespace Harvester.Cli.Tests.Commands;

public sealed class PlanCommandTests : IDisposable
{
    private const string Small = """
        {"name":"small","places":[{"name":"a","x":0,"y":0},{"name":"b","path":[[0,-40],[0,40]]}],"weathers":["clear","rain"],
        "frames":2,"hz":2,"cameras":[{"name":"c","width":64,"height":48}],"traffic":0,"pedestrians":0,"parked":0}
        """;

    private readonly TemporaryFolder _folder = new();

    private string PlanPath => _folder.PathOf("plan.json");

    private string Out => _folder.PathOf("out");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Init_writes_a_plan_that_check_and_schema_accept()
    {
        CliRun.Of("plan", "init", PlanPath).AssertDone();

        CliRun check = CliRun.Of("plan", "check", PlanPath);
        check.AssertDone();
        Assert.Equal($"{PlanPath}: the plan is valid\n", check.Out);
        Assert.True(PlanSchema().Evaluate(JsonNode.Parse(File.ReadAllText(PlanPath))).IsValid);
        CliRun.Of("plan", "init", PlanPath).AssertFailed(ExitCode.Usage, "exists already");
    }

    [Theory]
    [InlineData("""{"name":"p","places":[{"name":"a","x":1}]}""")]
    [InlineData("""{"name":"p","places":[{"name":"a","x":1,"y":1,"spread":2}]}""")]
    [InlineData("""{"name":"p","places":[{"name":"a","spread":2}],"weathers":["sunny"]}""")]
    [InlineData("""{"name":"p","places":[{"name":"a","spread":2}],"cameras":[{"name":"c","rig":"r.json","width":64}]}""")]
    [InlineData("""{"name":"p","places":[{"name":"a","spread":2}],"frame":3}""")]
    public void Check_and_schema_refuse_the_same_plans(string text)
    {
        File.WriteAllText(PlanPath, text);

        Assert.Equal(ExitCode.BadData, CliRun.Of("plan", "check", PlanPath).ExitCode);
        Assert.False(PlanSchema().Evaluate(JsonNode.Parse(text)).IsValid);
    }

    [Fact]
    public void Rig_with_an_impossible_name_is_a_problem()
    {
        string plan = _folder.PathOf("plan.json");
        File.WriteAllText(plan, """{"name":"p","places":[{"name":"a","spread":2}],"cameras":[{"name":"c","rig":"a\u0000b.json"}]}""");

        CliRun run = CliRun.Of("plan", "check", plan);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains("rig of camera 'c'", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Check_lists_every_problem()
    {
        File.WriteAllText(PlanPath, """{"name":"p","places":[{"name":"a","spread":2}],"hz":0,"hour":["12:00"]}""");

        CliRun run = CliRun.Of("plan", "check", PlanPath);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Equal(
            "hz must be a number from 0.01 to 60.\nhour is not a field of a plan. Correct its name or delete it.\n"
                + $"{PlanPath}: 2 problems\n",
            run.Out
        );
    }

    [Fact]
    public void Show_lists_trials_in_order_with_an_estimate()
    {
        File.WriteAllText(PlanPath, Small);

        string[] lines = CliRun.Of("plan", "show", PlanPath).Out.Split('\n');

        Assert.StartsWith("1  a_clear_1200_c_001  2 images  at 0,0  seed ", lines[0], StringComparison.Ordinal);
        Assert.StartsWith("4  b_rain_1200_c_001  2 images  at 0,-40  seed ", lines[3], StringComparison.Ordinal);
        Assert.StartsWith("4 trials: at most 8 images, about ", lines[4], StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Run_makes_a_valid_session_of_every_trial()
    {
        File.WriteAllText(PlanPath, Small);

        CliRun.Of("plan", "run", PlanPath, "--out", Out).AssertDone();

        string[] sessions = Directory.GetDirectories(Path.Combine(Out, "trials"));
        Assert.Equal(4, sessions.Length);
        Assert.All(sessions, session => CliRun.Of("validate", session).AssertDone());
        Assert.Equal(4, File.ReadAllLines(Path.Combine(Out, "plan-status.jsonl")).Length);
        Assert.Contains("\"state\":\"finished\"", File.ReadAllText(Path.Combine(Out, "heartbeat.json")), StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Shards_together_make_the_sessions_of_a_whole_run()
    {
        File.WriteAllText(PlanPath, Small);
        CliRun.Of("plan", "run", PlanPath, "--out", Out).AssertDone();
        string divided = _folder.PathOf("divided");
        CliRun.Of("plan", "run", PlanPath, "--out", divided, "--shard", "1/2").AssertDone();
        CliRun.Of("plan", "run", PlanPath, "--out", divided, "--shard", "2/2").AssertDone();

        AssertSameFiles(Path.Combine(Out, "trials"), Path.Combine(divided, "trials"));
    }

    [Theory]
    [InlineData("--detail", "full")]
    [InlineData("--roads", "other")]
    public void Resume_refuses_another_world(string option, string value)
    {
        // All trials are done, so that nothing is built.
        File.WriteAllText(PlanPath, Small.Replace("\"clear\",\"rain\"", "\"clear\"", StringComparison.Ordinal));
        string roads = _folder.PathOf("roads.csv");
        string other = _folder.PathOf("other.csv");
        File.WriteAllText(roads, WritingCommand.Roads);
        File.WriteAllText(other, WritingCommand.Roads.Replace("200,30", "190,30", StringComparison.Ordinal));
        Directory.CreateDirectory(Out);
        File.WriteAllText(
            Path.Combine(Out, "plan-status.jsonl"),
            string.Concat(
                ((string[])["a", "b"]).Select(place =>
                    $$"""{"trial":"{{place}}_clear_1200_c_001","state":"done","attempt":1,"frames":2}""" + "\n"
                )
            )
        );
        File.Copy(PlanPath, Path.Combine(Out, "plan.json"));
        string[] command = ["plan", "run", PlanPath, "--out", Out, "--resume"];
        CliRun.Of([.. command, "--roads", roads]).AssertDone();

        CliRun
            .Of(value == "other" ? [.. command, option, other] : [.. command, "--roads", roads, option, value])
            .AssertFailed(ExitCode.Usage, "has results of other roads, other paint or another detail");
        CliRun.Of([.. command, "--roads", roads]).AssertDone();
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public async Task Resume_gives_the_bytes_of_an_uninterrupted_run()
    {
        File.WriteAllText(PlanPath, Small.Replace("\"frames\":2", "\"frames\":8", StringComparison.Ordinal));
        CliRun.Of("plan", "run", PlanPath, "--out", Out).AssertDone();
        string stopped = _folder.PathOf("stopped");
        using (var cancellation = new CancellationTokenSource())
        {
            Task<CliRun> run = CliRun.BesideAsync(cancellation.Token, "plan", "run", PlanPath, "--out", stopped);
            SpinWait.SpinUntil(() => run.IsCompleted || Directory.Exists(Path.Combine(stopped, "trials", "a_rain_1200_c_001", "frames")));
            await cancellation.CancelAsync();
            Assert.Equal(ExitCode.Cancelled, (await run).ExitCode);
        }

        CliRun
            .Of("plan", "run", PlanPath, "--out", stopped)
            .AssertFailed(ExitCode.Usage, "has results of this plan. Continue with --resume");
        CliRun.Of("plan", "run", PlanPath, "--out", stopped, "--resume").AssertDone();

        AssertSameFiles(Path.Combine(Out, "trials"), Path.Combine(stopped, "trials"));
        Assert.Equal(
            File.ReadAllText(Path.Combine(Out, "plan-status.jsonl")),
            File.ReadAllText(Path.Combine(stopped, "plan-status.jsonl"))
        );
    }

    [Fact]
    public void Trial_that_fails_three_times_is_skipped_and_reported()
    {
        File.WriteAllText(
            PlanPath,
            Small
                .Replace("\"x\":0", "\"x\":9000", StringComparison.Ordinal)
                .Replace(
                    """
                    ,"rain"
                    """,
                    "",
                    StringComparison.Ordinal
                )
        );

        CliRun run = CliRun.Of("plan", "run", PlanPath, "--out", Out);

        Assert.Equal(ExitCode.HarvestFault, run.ExitCode);
        Assert.Contains("1 trial done, 1 skipped, 2 frames\n", run.Out, StringComparison.Ordinal);
        Assert.EndsWith("1 trial skipped after 3 failures each: a_clear_1200_c_001\n", run.Error, StringComparison.Ordinal);
        Assert.Contains("attempt 3 of 3: No road lies within", run.Error, StringComparison.Ordinal);
        Assert.Equal("b_clear_1200_c_001", Path.GetFileName(Assert.Single(Directory.GetDirectories(Path.Combine(Out, "trials")))));
    }

    [Fact]
    public void Folder_of_another_plan_is_refused()
    {
        File.WriteAllText(PlanPath, Small);
        Directory.CreateDirectory(Out);
        File.WriteAllText(Path.Combine(Out, "plan.json"), PlanInitCommand.Example);

        CliRun.Of("plan", "run", PlanPath, "--out", Out, "--resume").AssertFailed(ExitCode.Usage, "has results of another plan");
    }

    [Fact]
    public void Space_that_the_world_lacks_is_one_line()
    {
        File.WriteAllText(PlanPath, """{"name":"p","places":[{"name":"a","space":"NOWHERE"}]}""");

        CliRun
            .Of("plan", "show", PlanPath)
            .AssertFailed(ExitCode.Usage, "No space 'NOWHERE' of the place 'a' is in this world, which has ");
    }

    [Fact]
    public void Spread_place_with_the_name_of_another_is_one_line()
    {
        File.WriteAllText(PlanPath, """{"name":"p","places":[{"name":"a","spread":2},{"name":"A-1","x":0,"y":0}]}""");

        CliRun.Of("plan", "show", PlanPath).AssertFailed(ExitCode.Usage, "Two places are called 'a-1' once the spread ones are chosen.");
    }

    [Fact]
    public void Run_of_too_many_images_is_refused()
    {
        File.WriteAllText(
            PlanPath,
            """{"name":"p","places":[{"name":"a","x":0,"y":0}],"weathers":["clear","rain","foggy"],"""
                + """ "repetitions":1000,"frames":1000000}"""
        );

        CliRun.Of("plan", "run", PlanPath, "--out", Out).AssertFailed(ExitCode.Usage, "The plan has 3000000000 images; a run may have ");
    }

    [Fact]
    public void Resolved_plan_has_the_same_trials_at_points()
    {
        File.WriteAllText(PlanPath, PlanInitCommand.Example);
        string resolved = _folder.PathOf("resolved.json");
        CliRun.Of("plan", "resolve", PlanPath, "--out", resolved).AssertDone();

        Assert.Equal(CliRun.Of("plan", "show", PlanPath).Out, CliRun.Of("plan", "show", resolved).Out);
        JsonNode plan = JsonNode.Parse(File.ReadAllText(resolved))!;
        Assert.True(PlanSchema().Evaluate(plan).IsValid);
        Assert.All(plan["places"]!.AsArray(), place => Assert.NotNull(place!["x"]));
    }

    private static JsonSchema PlanSchema()
    {
        using Stream stream = typeof(SchemaValidator).Assembly.GetManifestResourceStream("Harvester.Datasets.plan.schema.json")!;
        using var reader = new StreamReader(stream);
        return JsonSchema.FromText(reader.ReadToEnd());
    }

    private static void AssertSameFiles(string expected, string actual)
    {
        string[] names = NamesIn(expected);
        Assert.Equal(names, NamesIn(actual));
        Assert.All(
            names,
            name => Assert.Equal(File.ReadAllBytes(Path.Combine(expected, name)), File.ReadAllBytes(Path.Combine(actual, name)))
        );
    }

    private static string[] NamesIn(string folder) =>
        [.. Directory.GetFiles(folder, "*", SearchOption.AllDirectories).Select(path => Path.GetRelativePath(folder, path)).Order()];
}
