using Harvester.Cli.Terminals;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

public sealed class HarvestPairsTests(HarvestedPairs harvested) : IClassFixture<HarvestedPairs>, IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Each_frame_has_all_its_pictures()
    {
        FrameLabel[] labels = [.. new SessionReader(harvested.Session).ReadLabels()];

        Assert.Equal(4, labels.Length);
        Assert.All(
            labels,
            label =>
            {
                Assert.Equal(4, label.Pairs.Count(pair => pair.Without.Count == 0));
                Assert.All(label.Pairs, pair => Assert.True(File.Exists(Path.Combine(harvested.Session, pair.File!))));
                Assert.All(label.Pairs.SelectMany(pair => pair.Without), id => Assert.Contains(label.Objects, item => item.Id == id));
            }
        );
        Assert.Contains(labels, label => label.Pairs.Any(pair => pair.Without.Count > 0));
    }

    [Fact]
    public void Session_and_its_shards_are_valid()
    {
        foreach (string session in (string[])[harvested.Session, harvested.PathOf("part-1"), harvested.PathOf("part-2")])
        {
            CliRun run = CliRun.Of("validate", "--schema", session);
            Assert.True(run.ExitCode == ExitCode.Done, run.Out + run.Error);
        }
    }

    [Fact]
    public void Merged_shards_have_the_bytes_of_a_single_run()
    {
        CliRun
            .Of("merge", harvested.PathOf("part-2"), harvested.PathOf("part-1"), "--out", _folder.PathOf("whole"), "--no-report")
            .AssertDone();

        AssertSame(harvested.Session, _folder.PathOf("whole"));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Resumed_harvest_has_the_bytes_of_a_single_run()
    {
        string torn = _folder.PathOf("torn");
        CliRun.Of(["harvest", "--out", torn, .. HarvestedPairs.Options.Split(' ')]).AssertDone();
        string labels = Path.Combine(torn, "labels.jsonl");
        string[] lines = File.ReadAllLines(labels);
        File.WriteAllText(labels, string.Join('\n', lines.Take(2)) + "\n" + lines[2][..40]);
        File.WriteAllText(Path.Combine(torn, ".harvester-unfinished"), "harvester harvest " + HarvestedPairs.Options);

        CliRun.Of(["harvest", "--out", torn, "--resume", .. HarvestedPairs.Options.Split(' ')]).AssertDone();

        AssertSame(harvested.Session, torn);
    }

    [Fact]
    public void Relabelled_session_keeps_pictures_and_labels()
    {
        CliRun.Of("relabel", harvested.Session, "--out", _folder.PathOf("again"), "--no-report").AssertDone();

        Assert.Equal(
            File.ReadAllText(Path.Combine(harvested.Session, "labels.jsonl")),
            File.ReadAllText(_folder.PathOf("again/labels.jsonl"))
        );
        CliRun.Of("validate", _folder.PathOf("again")).AssertDone();
    }

    [Fact]
    public void Damaged_further_picture_is_found_and_its_frame_lost()
    {
        string copy = _folder.PathOf("copy");
        CliRun.Of("relabel", harvested.Session, "--out", copy, "--images", "copy", "--no-report").AssertDone();
        byte[] bytes = File.ReadAllBytes(Path.Combine(copy, "pairs/00000001/rain-12.png"));
        bytes[^20] ^= 1;
        File.WriteAllBytes(Path.Combine(copy, "pairs/00000001/rain-12.png"), bytes);
        File.Delete(Path.Combine(copy, "pairs/00000002/clear-00.png"));

        CliRun run = CliRun.Of("validate", copy);
        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains("pairs/00000001/rain-12.png", run.Out, StringComparison.Ordinal);
        Assert.Contains("further picture 'pairs/00000002/clear-00.png' is missing", run.Out, StringComparison.Ordinal);
        CliRun.Of("repair", copy, "--out", _folder.PathOf("repaired"));
        Assert.Equal([0, 3], new SessionReader(_folder.PathOf("repaired")).ReadLabels().Select(label => label.Frame));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Session_with_pairs_is_overwritten_without_leftovers()
    {
        string folder = _folder.PathOf("used");
        CliRun.Of("harvest", "--out", folder, "--frames", "1", "--size", "64x48", "--pair-hours", "0", "--no-report").AssertDone();
        Assert.True(Directory.Exists(Path.Combine(folder, "pairs")));
        CliRun.Of("harvest", "--out", folder, "--frames", "1", "--size", "64x48", "--overwrite", "--no-report").AssertDone();

        Assert.False(Directory.Exists(Path.Combine(folder, "pairs")));
    }

    [Theory]
    [InlineData("--pair-weathers sunny", "'sunny'")]
    [InlineData("--pair-weathers rain,rain", "'rain' twice")]
    [InlineData("--pair-hours 24", "'24'")]
    [InlineData("--pair-hours 06", "'06'")]
    [InlineData("--pair-without trees", "'trees'")]
    [InlineData("--pair-without 0", "'0'")]
    [InlineData("--pair-ticks 5", "'5'")]
    [InlineData("--pair-hours 6 --rig {0}", "--rig")]
    public void Wrong_option_is_refused_in_one_line(string options, string message)
    {
        string rig = _folder.File("rig.json", HarvestedRig.Rig);
        string[] words = [.. options.Split(' ').Select(word => word.Replace("{0}", rig, StringComparison.Ordinal))];
        CliRun run = CliRun.Of(["harvest", "--out", _folder.PathOf("none"), .. words]);

        run.AssertFailed(ExitCode.Usage, message);
        Assert.False(Directory.Exists(_folder.PathOf("none")));
    }

    private static void AssertSame(string expected, string actual)
    {
        string[] files = [.. Files(expected)];
        Assert.Equal(files, Files(actual));
        Assert.All(
            files,
            file => Assert.Equal(File.ReadAllBytes(Path.Combine(expected, file)), File.ReadAllBytes(Path.Combine(actual, file)))
        );
    }

    private static IEnumerable<string> Files(string folder) =>
        Directory
            .EnumerateFiles(folder, "*", SearchOption.AllDirectories)
            .Select(file => Path.GetRelativePath(folder, file))
            .Order(StringComparer.Ordinal);
}
