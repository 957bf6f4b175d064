using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

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
        CheckReport(session);
        CheckNuScenes(session);
    }

    /// <summary>The table of the report has every event, with its kind and participants.</summary>
    private void CheckReport(string session)
    {
        CliRun.Of("report", session, "--out", _folder.PathOf("report.html")).AssertDone();
        string page = File.ReadAllText(_folder.PathOf("report.html"));
        int from = page.IndexOf("\"eventRows\":", StringComparison.Ordinal) + "\"eventRows\":".Length;
        var json = new Utf8JsonReader(Encoding.UTF8.GetBytes(page[from..]));
        JsonArray rows = JsonNode.Parse(ref json)!.AsArray();
        DrivingEvent[] events = [.. new SessionReader(session).ReadEvents().OrderBy(each => each.Id)];
        Assert.Equal(events.Select(each => each.Id.ToString()), rows.Select(row => (string?)row![1]));
        Assert.Equal(events.Select(each => JsonName.Of(each.Kind)), rows.Select(row => (string?)row![2]));
        Assert.All(events.Zip(rows), each => Assert.Equal(each.First.Participants.Count, ((string?)each.Second![5])!.Split(", ").Length));
        Assert.Contains(rows, row => row![0] is not null);
    }

    /// <summary>Samples of nuScenes have the attributes of the events of the ego, and boxes those of the events of the object.</summary>
    private void CheckNuScenes(string session)
    {
        CliRun.Of("export", session, "--format", "nuscenes", "--out", _folder.PathOf("nuscenes")).AssertDone();
        CliRun.Of("validate", _folder.PathOf("nuscenes")).AssertDone();
        Dictionary<string, string> names = Table("attribute").ToDictionary(row => (string)row!["token"]!, row => (string)row!["name"]!);
        Dictionary<int, DrivingEvent> events = new SessionReader(session).ReadEvents().ToDictionary(each => each.Id);
        FrameLabel[] labels = [.. new SessionReader(session).ReadLabels()];
        Dictionary<long, FrameLabel> byTime = labels.ToDictionary(label => (long)Math.Round(label.TimeSeconds * 1e6));
        Dictionary<string, FrameLabel> samples = [];
        const long start = 1_577_836_800_000_000;
        foreach (JsonNode? row in Table("sample"))
        {
            FrameLabel label = samples[(string)row!["token"]!] = byTime[(long)row["timestamp"]! - start];
            Assert.Equal(Expected(label, null), Named(row));
        }

        int found = 0;
        foreach (JsonNode? row in Table("sample_annotation"))
        {
            // Boxes of nuScenes have no numbers: the object is the one of the label in the same place.
            found += Named(row!).Length;
            FrameLabel label = samples[(string)row!["sample_token"]!];
            Assert.All(Named(row!), name => Assert.Contains(label.Events!, mark => "event." + JsonName.Of(mark.Kind) == name));
        }

        int expected = samples.Values.Sum(label => label.Objects.Where(item => IsBox(item)).Sum(item => Expected(label, item.Id).Length));
        Assert.Equal(expected, found);
        Assert.Contains(names.Values, name => name.StartsWith("event.", StringComparison.Ordinal));

        JsonArray Table(string name) => JsonNode.Parse(File.ReadAllText(_folder.PathOf($"nuscenes/v1.0-gta/{name}.json")))!.AsArray();

        string[] Named(JsonNode row) => [.. row["event_attribute_tokens"]!.AsArray().Select(token => names[(string)token!]).Order()];

        string[] Expected(FrameLabel label, int? id) =>
            [
                .. label
                    .Events!.Where(mark => events[mark.Id].Participants.Any(participant => participant.Object == id))
                    .Select(mark => "event." + JsonName.Of(mark.Kind))
                    .Distinct()
                    .Order(),
            ];

        static bool IsBox(ObjectLabel item) => VehicleClasses.AreVehicles(item.Class) || item.Class == ObjectClass.Pedestrian;
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
    [Trait("Category", "Heavy")]
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
