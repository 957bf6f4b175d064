using Harvester.Cli.Terminals;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Tests.Commands;

public sealed class CounterfactualCommandTests : IDisposable
{
    private const int Frames = 8;
    private const int Changed = 3;

    private readonly TemporaryFolder _folder = new();

    private string Set => _folder.PathOf("set");

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Runs_agree_until_the_change_and_differ_after_it()
    {
        int id = ObjectAhead();
        Make("frame 3: ego brakes 7", $"frame 3: without {id}", $"frame 3: {id} drives 1; frame 5: weather rain").AssertDone();
        string[] files = [.. Directory.GetFiles(Path.Combine(Set, "base"), "*0000*", SearchOption.AllDirectories)];
        Assert.True(files.Length >= 3 * Frames, $"A session of {files.Length} files.");
        FrameLabel[] original = Labels("base");
        for (int run = 1; run <= 3; run++)
        {
            foreach (string file in files.Where(file => NumberOf(file) <= Changed))
            {
                string other = Path.Combine(Set, $"change-0{run}", Path.GetRelativePath(Path.Combine(Set, "base"), file));
                Assert.True(File.ReadAllBytes(file).AsSpan().SequenceEqual(File.ReadAllBytes(other)), other);
            }

            string[] lines = File.ReadAllLines(Path.Combine(Set, $"change-0{run}", "labels.jsonl"));
            string[] same = File.ReadAllLines(Path.Combine(Set, "base", "labels.jsonl"));
            Assert.Equal(same[..(Changed + 1)], lines[..(Changed + 1)]);
            Assert.NotEqual(same[^1], lines[^1]);
        }

        // The ego that brakes with 7 m/s² has lost as much more speed in the 0.4 s to the last frame than the other.
        FrameLabel[] braked = Labels("change-01");
        double lost = original[^1].Ego.Velocity.Length - braked[^1].Ego.Velocity.Length;
        double seconds = original[^1].TimeSeconds - original[Changed].TimeSeconds;
        Assert.InRange(lost, Math.Min(original[Changed].Ego.Velocity.Length, 7 * seconds) - 1.5, (7 + 2) * seconds);

        // The other is there until frame 3, and nowhere afterwards.
        FrameLabel[] without = Labels("change-02");
        Assert.Contains(without[Changed].Objects, item => item.Id == id);
        Assert.DoesNotContain(without[(Changed + 1)..].SelectMany(label => label.Objects), item => item.Id == id);
        Assert.Contains(original[Changed + 1].Objects, item => item.Id == id);

        FrameLabel[] rained = Labels("change-03");
        Assert.Equal("clear", rained[5].Environment.Weather);
        Assert.Equal("rain", rained[6].Environment.Weather);

        CliRun pairs = CliRun.Of("pairs", Set, "--out", _folder.PathOf("pairs"));
        Assert.Equal((ExitCode.Done, $"{_folder.PathOf("pairs")}: 8 groups, 32 pictures\n"), (pairs.ExitCode, pairs.Out));
        string[] changes = File.ReadAllLines(_folder.PathOf("pairs/changes.csv"));
        Assert.Equal("run,change,first_label_that_differs,first_image_that_differs", changes[0]);
        Assert.StartsWith("change-01,frame 3: ego brakes 7,4,", changes[1], StringComparison.Ordinal);
        Assert.Equal($"change-02,frame 3: without {id},4,4", changes[2]);
        string[] index = File.ReadAllLines(_folder.PathOf("pairs/index.csv"));
        Assert.Equal(1 + (4 * Frames), index.Length);
        Assert.All(index.Skip(1), row => Assert.True(File.Exists(_folder.PathOf("pairs/" + row.Split(',')[2])), row));
        Assert.Equal(
            File.ReadAllBytes(Path.Combine(Set, "change-02/frames/00000006.png")),
            File.ReadAllBytes(_folder.PathOf("pairs/images/00000006/change-02.png"))
        );
        CliRun.Of("validate", Path.Combine(Set, "change-03")).AssertDone();
    }

    [Theory]
    [InlineData("brakes", "is not of the form")]
    [InlineData("frame 3: ego brakes 20", "is not of the form")]
    [InlineData("frame 3: weather sunny", "is not of the form")]
    [InlineData("frame 7: ego brakes 2", "nothing follows frame 7")]
    public void Change_that_cannot_be_is_refused(string change, string message)
    {
        CliRun run = Make(change);
        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Set));
    }

    private CliRun Make(params string[] changes) =>
        CliRun.Of(["counterfactual", "--out", Set, .. Options, .. changes.SelectMany(change => new[] { "--change", change })]);

    private static string[] Options =>
        [.. $"--seed 11 --places 1 --frames {Frames} --size 96x72 --range 120 --crashes --masks --no-report".Split(' ')];

    /// <summary>Number of a car in traffic that is labelled in all frames.</summary>
    private int ObjectAhead()
    {
        string first = _folder.PathOf("first");
        CliRun.Of(["harvest", "--out", first, .. Options]).AssertDone();
        FrameLabel[] labels = [.. new SessionReader(first).ReadLabels()];
        return labels[0]
            .Objects.First(item =>
                item.Velocity is { Length: > 1 }
                && item.Vehicle is null
                && VehicleClasses.AreVehicles(item.Class)
                && labels.All(label => label.Objects.Any(other => other.Id == item.Id))
            )
            .Id;
    }

    private FrameLabel[] Labels(string run) => [.. new SessionReader(Path.Combine(Set, run)).ReadLabels()];

    private static int NumberOf(string file) => int.Parse(Path.GetFileName(file)[..8]);
}
