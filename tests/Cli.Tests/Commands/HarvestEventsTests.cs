using Harvester.Cli.Terminals;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Events from the command line to the commands that read a session.</summary>
public sealed class HarvestEventsTests : IDisposable
{
    /// <summary>Three seconds in which a vehicle brakes hard soon, and then two collide.</summary>
    private static readonly string[] Busy =
    [
        .. "--frames 14 --size 64x48 --hz 4 --places 1 --traffic 3 --pedestrians 5 --wander 3 --lane-changes 5 --seed 4".Split(' '),
        .. "--events --no-report --no-scenes --range 20 --max-camera-error 0".Split(' '),
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Events_are_valid_and_kept_by_shards_and_derived_sessions()
    {
        string session = _folder.PathOf("session");
        CliRun.Of(["harvest", "--out", session, .. Busy]).AssertDone();
        CliRun.Of("validate", "--schema", session).AssertDone();
        string events = File.ReadAllText(Path.Combine(session, "events.jsonl"));
        Assert.NotEmpty(events);
        Assert.Contains(new SessionReader(session).ReadLabels(), label => label.Events!.Count > 0);

        foreach (int shard in new[] { 1, 2 })
        {
            CliRun.Of(["harvest", "--out", _folder.PathOf($"part-{shard}"), .. Busy, "--shard", $"{shard}/2"]).AssertDone();
        }

        CliRun
            .Of("merge", _folder.PathOf("part-1"), _folder.PathOf("part-2"), "--out", _folder.PathOf("merged"), "--no-report")
            .AssertDone();
        foreach (string name in new[] { "events.jsonl", "labels.jsonl", "manifest.jsonl", "session.json" })
        {
            Assert.Equal(File.ReadAllText(Path.Combine(session, name)), File.ReadAllText(_folder.PathOf($"merged/{name}")));
        }

        CliRun.Of("repair", session, "--out", _folder.PathOf("repaired")).AssertDone();
        Assert.Equal(events, File.ReadAllText(_folder.PathOf("repaired/events.jsonl")));
        CliRun stats = CliRun.Of("stats", session);
        int brakings = new SessionReader(session).ReadEvents().Count(each => each.Kind == EventKind.HardBraking);
        Assert.Contains($"event hardBraking: {brakings}, ", stats.Out, StringComparison.Ordinal);
        foreach (string format in new[] { "csv", "openlabel" })
        {
            CliRun.Of("export", session, "--format", format, "--out", _folder.PathOf(format)).AssertDone();
            CliRun.Of("validate", _folder.PathOf(format)).AssertDone();
        }

        int marks = new SessionReader(session).ReadLabels().Sum(label => label.Events!.Count);
        Assert.Equal(marks + 1, File.ReadAllLines(_folder.PathOf("csv/events.csv")).Length);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Keep_around_writes_the_frames_near_events_and_no_others()
    {
        const double seconds = 1;
        string all = _folder.PathOf("all");
        string kept = _folder.PathOf("kept");
        CliRun.Of(["harvest", "--out", all, .. Busy]).AssertDone();
        CliRun.Of(["harvest", "--out", kept, .. Busy, "--keep-around", "1s", "--keep-kinds", "hardBraking"]).AssertDone();
        CliRun.Of("validate", "--schema", kept).AssertDone();
        DrivingEvent[] events = [.. new SessionReader(all).ReadEvents().Where(each => each.Kind == EventKind.HardBraking)];

        // What began after the last frame cannot be known at it.
        FrameLabel[] labels = [.. new SessionReader(all).ReadLabels()];
        int[] expected =
        [
            .. labels
                .Where(label =>
                    events.Any(each =>
                        each.BeginSeconds <= labels[^1].TimeSeconds
                        && label.TimeSeconds >= each.BeginSeconds - seconds - 1e-6
                        && label.TimeSeconds <= each.EndSeconds + seconds + 1e-6
                    )
                )
                .Select(label => label.Frame),
        ];

        Assert.InRange(expected.Length, 1, labels.Length - 1);
        Assert.Equal(expected, new SessionReader(kept).ReadLabels().Select(label => label.Frame));
        Assert.Equal(File.ReadAllText(Path.Combine(all, "events.jsonl")), File.ReadAllText(Path.Combine(kept, "events.jsonl")));
    }

    [Theory]
    [InlineData("\"kind\":\"hardBraking\"", "\"kind\":\"collision\"", "participants")]
    [InlineData("\"id\":1,", "\"id\":0,", "ids begin at 1")]
    [InlineData("\"deceleration\":", "\"deceleration\":1", "deceleration is 1")]
    [InlineData("\"endSeconds\":", "\"endSeconds\":-", "must be in this order")]
    public void Damaged_event_is_a_problem(string text, string damage, string problem)
    {
        string session = _folder.PathOf("session");
        CliRun
            .Of("harvest", "--out", session, "--frames", "1", "--size", "64x48", "--seed", "2", "--events", "--no-report", "--no-scenes")
            .AssertDone();
        string line =
            "{\"id\":1,\"kind\":\"hardBraking\",\"beginSeconds\":1,\"peakSeconds\":1,\"endSeconds\":2,\"end\":\"over\",\"firstFrame\":null,"
            + "\"lastFrame\":null,\"participants\":[{\"object\":null,\"class\":null,\"model\":\"blista\",\"position\":[0,0,0],"
            + "\"right\":[1,0,0],\"forward\":[0,1,0],\"up\":[0,0,1],"
            + "\"modelMin\":[-1,-2,0],\"modelMax\":[1,2,1],\"velocity\":[0,5,0],\"yawRate\":0}],"
            + "\"measures\":{\"deceleration\":6,\"speedBefore\":8,\"speedAfter\":5}}\n";
        string file = Path.Combine(session, "events.jsonl");
        File.WriteAllText(file, line);
        Assert.DoesNotContain("events.jsonl, line", CliRun.Of("validate", session).Out, StringComparison.Ordinal);
        File.WriteAllText(file, line.Replace(text, damage, StringComparison.Ordinal));

        CliRun validated = CliRun.Of("validate", session);

        Assert.Equal(ExitCode.BadData, validated.ExitCode);
        Assert.Matches($"events.jsonl, line 1: .*{problem}", validated.Out);
    }

    [Theory]
    [InlineData("--keep-around 5s", "needs --events")]
    [InlineData("--events --keep-kinds collision", "needs --keep-around")]
    [InlineData("--events --keep-around 90", "must be a time from 1s to 60s")]
    [InlineData("--events --keep-around 5s --keep-kinds crash", "must be a list of nearMiss, hardBraking, collision")]
    [InlineData("--events --keep-around 60s --size 3840x2160", "held back")]
    [InlineData("--events --keep-around 5s --shard 1/2", "not in shards")]
    public void Wrong_options_are_refused(string options, string message)
    {
        CliRun run = CliRun.Of(["harvest", "--out", _folder.PathOf("none"), .. options.Split(' ')]);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }
}
