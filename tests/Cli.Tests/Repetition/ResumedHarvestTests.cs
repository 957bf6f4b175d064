using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>Harvests that were stopped after some frames and are resumed.</summary>
public sealed class ResumedHarvestTests : IDisposable
{
    private const int Recorded = 3;

    private readonly TemporaryFolder _folder = new();

    public ResumedHarvestTests() => File.WriteAllText(Roads, WritingCommand.Roads);

    private string Roads => _folder.PathOf("roads.csv");

    private string Out => _folder.PathOf("out");

    private string Whole => _folder.PathOf("whole");

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("1/1")]
    [InlineData("2/2")]
    public void Resumed_harvest_ends_as_if_undisturbed(string shard)
    {
        Harvest(Whole, shard).AssertDone();
        Stop(shard);

        CliRun run = Harvest(Out, shard, "--resume");

        run.AssertDone();
        Assert.Contains($", {Recorded} of them from an earlier run", run.Out, StringComparison.Ordinal);
        Assert.Equal("", FolderContent.Of(Out).DifferenceFrom(FolderContent.Of(Whole)));
    }

    [Fact]
    public void Resumed_harvest_leaves_recorded_frames_alone()
    {
        Harvest(Whole, "1/1").AssertDone();
        Stop("1/1");
        byte[] changed = [1, 2, 3];
        File.WriteAllBytes(FrameOf(Out, Recorded - 1), changed);

        Harvest(Out, "1/1", "--resume").AssertDone();

        Assert.Equal(changed, File.ReadAllBytes(FrameOf(Out, Recorded - 1)));
        Assert.Equal(File.ReadAllBytes(FrameOf(Whole, Recorded)), File.ReadAllBytes(FrameOf(Out, Recorded)));
    }

    [Fact]
    public void Resume_without_a_session_starts_one()
    {
        Harvest(Whole, "1/1").AssertDone();

        Harvest(Out, "1/1", "--resume").AssertDone();

        Assert.Equal("", FolderContent.Of(Out).DifferenceFrom(FolderContent.Of(Whole)));
    }

    [Theory]
    [InlineData("1/1")]
    [InlineData("2/2")]
    public void Resume_of_a_finished_harvest_is_success(string shard)
    {
        Harvest(Out, shard).AssertDone();
        FolderContent complete = FolderContent.Of(Out);

        CliRun run = Harvest(Out, shard, "--resume");

        run.AssertDone();
        Assert.Contains("the harvest is finished already", run.Out, StringComparison.Ordinal);
        Assert.Equal(complete, FolderContent.Of(Out));
    }

    [Theory]
    [InlineData("--seed", "77")]
    [InlineData("--frames", "2")]
    [InlineData("--range", "50")]
    public void Resume_of_another_finished_harvest_is_refused(string option, string value)
    {
        CliRun.Of("harvest", "--out", Out, "--frames", "1", "--size", "80x60", "--roads", Roads, "--no-report").AssertDone();
        FolderContent complete = FolderContent.Of(Out);
        string[] asked = ["harvest", "--out", Out, "--size", "80x60", "--roads", Roads, "--no-report", "--resume", option, value];

        CliRun
            .Of(option == "--frames" ? asked : [.. asked, "--frames", "1"])
            .AssertFailed(ExitCode.Usage, $"'{Out}' already has a session.");

        Assert.Equal(complete, FolderContent.Of(Out));
    }

    [Fact]
    public void Resume_and_overwrite_together_are_refused() =>
        Harvest(Out, "1/1", "--resume", "--overwrite")
            .AssertFailed(ExitCode.Usage, "--resume continues a session, and --overwrite replaces it. Give only one of them.");

    private static string FrameOf(string folder, int frame) => Path.Combine(folder, FramePaths.Image(frame, ImageFormat.Png));

    private CliRun Harvest(string folder, string shard, params string[] more) =>
        CliRun.Of([
            "harvest",
            "--out",
            folder,
            "--frames",
            "8",
            "--shard",
            shard,
            "--seed",
            "5",
            "--size",
            "64x48",
            "--places",
            "2",
            "--no-report",
            "--roads",
            Roads,
            .. more,
        ]);

    /// <summary>
    /// Makes what a harvest leaves that is killed after some frames: the lines of these, half a line of the next with its image, and a
    /// header without an end.
    /// </summary>
    private void Stop(string shard)
    {
        Folders.Copy(Whole, Out);
        string labels = Path.Combine(Out, "labels.jsonl");
        string[] lines = File.ReadAllLines(labels);
        File.WriteAllText(labels, string.Join('\n', lines.Take(Recorded)) + "\n" + lines[Recorded][..20]);
        string manifest = Path.Combine(Out, Manifest.FileName);
        File.WriteAllLines(
            manifest,
            [.. File.ReadAllLines(manifest).Where(line => !line.Contains("session.json", StringComparison.Ordinal))]
        );
        string header = Path.Combine(Out, "session.json");
        string text = File.ReadAllText(header);
        File.WriteAllText(header, text[..text.IndexOf("\n  \"state\"", StringComparison.Ordinal)] + "\n  \"state\": \"recording\"\n}\n");
        foreach (string frame in Directory.GetFiles(Path.Combine(Out, FramePaths.Frames)).Order().Skip(Recorded + 1))
        {
            File.Delete(frame);
        }

        UnfinishedMark.Write(
            Out,
            CommandText.Of($"harvest --frames 8 --shard {shard} --seed 5 --size 64x48 --places 2 --no-report --roads {Roads}".Split(' '))
        );
    }
}
