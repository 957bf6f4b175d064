using System.Text.Json.Nodes;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>A scenario staged again with one thing changed.</summary>
public sealed class ScenarioChangeTests : IDisposable
{
    /// <summary>A car ahead brakes with 2 m/s² after a second.</summary>
    private const string Scenario = """
        {"name":"small","kind":"leader","place":{"metres":30},"ego":{"speed":8},"end":{"seconds":2.4},
        "actors":[{"id":"a","type":"vehicle","start":{"metresAhead":14}}],
        "events":[{"id":"slow","actor":"a","when":{"all":[{"seconds":1}]},"do":{"action":"brake","acceleration":2}},
        {"id":"never","actor":"a","when":{"all":[{"egoFaster":50}]},"do":{"action":"brake"}}]}
        """;

    private readonly TemporaryFolder _folder = new();

    private string Set => _folder.PathOf("set");

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Runs_agree_to_the_byte_until_the_change()
    {
        Make("at slow: ego brakes 7", "at slow: a brakes 7 for 0.5", "at slow: without a", "frame 5: weather rain").AssertDone();

        FrameLabel[] original = Labels("base");
        int changed = original.Count(label => label.TimeSeconds <= TimeOf("slow"));
        Assert.InRange(changed, 3, original.Length - 4);
        string[] files = Directory.GetFiles(Path.Combine(Set, "base"), "*0000*", SearchOption.AllDirectories);
        Assert.True(files.Length >= 2 * original.Length, $"A session of {files.Length} files.");
        for (int run = 1; run <= 4; run++)
        {
            int same = run == 4 ? 6 : changed;
            foreach (string file in files.Where(file => int.Parse(Path.GetFileName(file)[..8]) < same))
            {
                string other = Path.Combine(Set, $"change-0{run}", Path.GetRelativePath(Path.Combine(Set, "base"), file));
                Assert.True(File.ReadAllBytes(file).AsSpan().SequenceEqual(File.ReadAllBytes(other)), other);
            }

            string[] lines = File.ReadAllLines(Path.Combine(Set, "base", "labels.jsonl"));
            string[] otherwise = File.ReadAllLines(Path.Combine(Set, $"change-0{run}", "labels.jsonl"));
            Assert.Equal(lines[..same], otherwise[..same]);
            Assert.NotEqual(lines[^1], otherwise[^1]);
        }

        // The ego has lost about 7 m/s² in the time since, and the actor drives as in the base.
        double seconds = original[^1].TimeSeconds - TimeOf("slow");
        FrameLabel[] braked = Labels("change-01");
        Assert.InRange(SpeedOf(original, changed - 1, "ego") - SpeedOf(braked, ^1, "ego"), Math.Min(7, 7 * seconds) - 1, 8.5);
        Assert.Equal(SpeedOf(original, ^1, "a"), SpeedOf(braked, ^1, "a"), 1e-3);

        // The actor brakes by 7 m/s² for half a second instead of 2, and takes its speed again.
        FrameLabel[] yielded = Labels("change-02");
        FrameLabel after = yielded.First(label => label.TimeSeconds >= TimeOf("slow") + 0.45);
        Assert.InRange(SpeedOf([after], 0, "a"), 8 - (7 * 0.6), 8 - (7 * 0.4));
        Assert.True(SpeedOf(yielded, ^1, "a") > SpeedOf([after], 0, "a") + 0.5);

        Assert.Contains(original[^1].Objects, item => item.Id == IdOfActor());
        Assert.DoesNotContain(Labels("change-03")[(changed + 1)..].SelectMany(label => label.Objects), item => item.Id == IdOfActor());
        Assert.Equal("rain", Labels("change-04")[^1].Environment.Weather);
        JsonNode session = JsonNode.Parse(File.ReadAllText(Path.Combine(Set, "change-03", "session.json")))!;
        Assert.Equal("at slow: without a", (string?)session["settings"]!["change"]);
        CliRun.Of("validate", Path.Combine(Set, "change-03"), "--schema").AssertDone();
        CliRun.Of("pairs", Set, "--out", _folder.PathOf("pairs")).AssertDone();
        string[] table = File.ReadAllLines(_folder.PathOf("pairs/changes.csv"));
        Assert.StartsWith($"change-03,at slow: without a,{changed},", table[3], StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("at slow: b brakes 3", "the scenario has no actor 'b'")]
    [InlineData("at fast: a brakes 3", "the scenario has no event 'fast'")]
    [InlineData("at slow: a flies", "is not of the form")]
    public void Change_that_names_nothing_is_refused(string change, string message)
    {
        Make(change).AssertFailed(ExitCode.Usage, message);
        Assert.False(Directory.Exists(Set));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Event_that_did_not_begin_is_named() =>
        Make("at never: ego brakes 7").AssertFailed(ExitCode.Usage, "the event 'never' did not begin in the base session");

    [Fact]
    public void Harvest_has_no_actors() =>
        CliRun
            .Of("counterfactual", "--out", Set, "--places", "1", "--frames", "3", "--change", "frame 0: other brakes 3")
            .AssertFailed(ExitCode.Usage, "a harvest has no 'other'");

    private CliRun Make(params string[] changes)
    {
        string file = _folder.File("s.json", Scenario);
        string roads = _folder.File("roads.csv", WritingCommand.Roads);
        string[] options = $"--roads {roads} --near=0,-50 --hz 5 --size 96x72 --no-report --out {Set}".Split(' ');
        return CliRun.Of(["scenario", "run", file, .. options, .. changes.SelectMany(change => new[] { "--change", change })]);
    }

    private FrameLabel[] Labels(string run) => [.. new SessionReader(Path.Combine(Set, run)).ReadLabels()];

    /// <summary>
    /// The game time at which an event began in the base, seconds: that of the frame before, and a tick for each game frame since. Game
    /// frames count the ticks in which the game is frozen for a frame, too; those come before the number that its label has.
    /// </summary>
    private double TimeOf(string id)
    {
        JsonNode record = JsonNode.Parse(File.ReadAllText(Path.Combine(Set, "base", "scenario.json")))!;
        long frame = (long)
            record["events"]!.AsArray().Single(entry => (string?)entry!["event"] == id && (string?)entry["state"] == "begun")![
                "gameFrame"
            ]!;
        FrameLabel before = Labels("base").Last(label => label.GameFrame <= frame);
        return before.TimeSeconds + ((frame - before.GameFrame) / 60.0);
    }

    private int IdOfActor()
    {
        JsonNode record = JsonNode.Parse(File.ReadAllText(Path.Combine(Set, "base", "scenario.json")))!;
        int handle = (int)record["actors"]![0]!["handle"]!;
        JsonNode scene = JsonNode.Parse(File.ReadAllText(Path.Combine(Set, "base", "scenes", "00000001.json")))!;
        return (int)scene["entities"]!.AsArray().Single(entity => (int)entity!["handle"]! == handle)!["id"]!;
    }

    private double SpeedOf(FrameLabel[] labels, Index frame, string actor)
    {
        FrameLabel label = labels[frame];
        Vector3D velocity = actor == "ego" ? label.Ego.Velocity : label.Objects.Single(item => item.Id == IdOfActor()).Velocity;
        return velocity.Length;
    }
}
