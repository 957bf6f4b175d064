using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sharding;
using Harvester.Runs.Relabelling;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>Relabelling and merges that were stopped after some frames and are resumed: what is whole is not made again.</summary>
public sealed class ResumedDerivationTests : IClassFixture<ResumedDerivationTests.Inputs>, IDisposable
{
    private const int Frames = 6;
    private const int Finished = 4;

    private readonly Inputs _inputs;
    private readonly TemporaryFolder _folder = new();

    public ResumedDerivationTests(Inputs inputs) => _inputs = inputs;

    private string Out => _folder.PathOf("out");

    private string Whole => _folder.PathOf("whole");

    private string[] RelabelWords => ["relabel", _inputs.Session, "--range", "60", "--classes", "sign,trafficLight", "--no-report"];

    private string[] MergeWords => ["merge", .. _inputs.Shards, "--images", "copy", "--no-report"];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Resumed_relabel_ends_as_if_undisturbed()
    {
        StopRelabel();
        DateTime[] finished = MaskTimes();

        AssertResumed(RelabelWords);

        Assert.Equal(Finished, finished.Length);
        Assert.Equal(finished, MaskTimes()[..Finished]);
    }

    [Fact]
    public void Resumed_relabel_makes_only_the_frames_that_are_missing()
    {
        StopRelabel();
        var made = new List<int>();

        Relabeller(resume: true).Run(Out, made.Add);

        Assert.Equal([Finished + 1, Finished + 2], made);
    }

    [Theory]
    [InlineData("masks/00000002.png")]
    [InlineData("frames/00000002.png")]
    public void Frame_with_a_changed_file_is_made_again(string file)
    {
        StopRelabel();
        string path = Path.Combine(Out, file);
        byte[] bytes = File.ReadAllBytes(path);
        bytes[^1] ^= 1;
        File.Delete(path);
        File.WriteAllBytes(path, bytes);
        var made = new List<int>();

        Relabeller(resume: true).Run(Out, made.Add);

        Assert.Equal(3, made[0]);
        Assert.Equal(Frames, made[^1]);
        Run([.. RelabelWords, "--out", Whole]);
        Assert.Equal(File.ReadAllBytes(Path.Combine(Whole, file)), File.ReadAllBytes(path));
    }

    [Theory]
    [InlineData(20)]
    [InlineData(3000)]
    public void Journal_that_ends_within_a_line_is_cut(int bytes)
    {
        StopRelabel();
        using (FileStream journal = File.OpenWrite(Path.Combine(Out, ".harvester-journal")))
        {
            journal.SetLength(journal.Length - bytes);
        }

        AssertResumed(RelabelWords);
    }

    [Theory]
    [InlineData("../secret.png")]
    [InlineData("/etc/hostname")]
    [InlineData("frames/link.png")]
    public void Journal_that_names_a_file_outside_is_not_trusted(string name)
    {
        StopRelabel();
        File.WriteAllText(_folder.PathOf("secret.png"), "secret");
        File.CreateSymbolicLink(Path.Combine(Out, "frames/link.png"), _folder.PathOf("secret.png"));
        string journal = Path.Combine(Out, ".harvester-journal");
        string[] lines = File.ReadAllLines(journal);
        FileDigest digest = FileDigest.Of("secret");
        lines[1] = Manifest.FrameLine(0, FileDigest.Of(lines[2]), [new(name, digest)]);
        File.WriteAllText(journal, string.Join('\n', lines) + "\n");
        var made = new List<int>();

        Relabeller(resume: true).Run(Out, made.Add);

        Assert.Equal(1, made[0]);
        Assert.Equal("secret", File.ReadAllText(_folder.PathOf("secret.png")));
    }

    [Fact]
    public void Frames_made_with_other_options_are_not_kept()
    {
        StopRelabel();
        var made = new List<int>();

        new SessionRelabeller(new SessionReader(_inputs.Session), new RelabelOptions { RangeMetres = 50, Resume = true }).Run(
            Out,
            made.Add
        );

        Assert.Equal(1, made[0]);
    }

    [Fact]
    public void Relabel_without_resume_starts_anew()
    {
        StopRelabel();
        DateTime[] finished = MaskTimes();

        Run([.. RelabelWords, "--out", Out]);

        Assert.NotEqual(finished, MaskTimes()[..Finished]);
    }

    [Fact]
    public void Resumed_merge_ends_as_if_undisturbed()
    {
        StopMerge();
        string first = Path.Combine(Out, "frames/00000000.png");
        DateTime time = File.GetLastWriteTimeUtc(first);

        AssertResumed(MergeWords);

        Assert.Equal(time, File.GetLastWriteTimeUtc(first));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Resume_of_a_finished_result_is_success(bool relabels)
    {
        string[] words = relabels ? RelabelWords : MergeWords;
        Run([.. words, "--out", Out]);
        FolderContent complete = FolderContent.Of(Out);

        CliRun run = CliRun.Of([.. words, "--out", Out, "--resume"]);

        run.AssertDone();
        Assert.Contains("6 frames; the ", run.Out, StringComparison.Ordinal);
        Assert.Contains(" is finished already.", run.Out, StringComparison.Ordinal);
        Assert.Equal(complete, FolderContent.Of(Out));
    }

    [Theory]
    [InlineData("--range", "50")]
    [InlineData("--classes", "sign")]
    [InlineData("--shard", "1/2")]
    [InlineData("--min-box-area", "50")]
    public void Resume_of_another_finished_relabelling_is_refused(string option, string value)
    {
        Run([.. RelabelWords, "--out", Out]);
        FolderContent complete = FolderContent.Of(Out);
        string[] other = [.. RelabelWords.Where((word, index) => word != option && (index == 0 || RelabelWords[index - 1] != option))];

        CliRun.Of([.. other, option, value, "--out", Out, "--resume"]).AssertFailed(ExitCode.Usage, $"'{Out}' already has a session.");

        Assert.Equal(complete, FolderContent.Of(Out));
    }

    [Fact]
    public void Resume_of_a_finished_result_of_other_shards_is_refused()
    {
        Run([.. RelabelWords, "--out", Out]);

        CliRun.Of([.. MergeWords, "--out", Out, "--resume"]).AssertFailed(ExitCode.Usage, $"'{Out}' already has a session.");
    }

    [Fact]
    public void Resume_of_a_finished_merge_of_an_export_is_success()
    {
        string[] Shard(string number) =>
            ["export", _inputs.Session, "--format", "yolo", "--out", _folder.PathOf("shards"), "--shard", number];
        Run(Shard("1/2"));
        Run(Shard("2/2"));
        string[] words = ["merge", _folder.PathOf("shards"), "--out", Out];
        Run(words);
        FolderContent complete = FolderContent.Of(Out);

        CliRun.Of([.. words, "--resume"]).AssertDone();

        Assert.Equal(complete, FolderContent.Of(Out));
        CliRun.Of(words).AssertFailed(ExitCode.Usage, $"'{Out}'");
    }

    [Fact]
    public void Resume_and_overwrite_of_a_relabelling_are_refused() =>
        CliRun
            .Of([.. RelabelWords, "--out", Out, "--resume", "--overwrite"])
            .AssertFailed(ExitCode.Usage, "--resume continues a session, and --overwrite replaces it. Give only one of them.");

    private static void Run(string[] words) => CliRun.Of(words).AssertDone();

    private void AssertResumed(string[] words)
    {
        Run([.. words, "--out", Out, "--resume"]);
        Run([.. words, "--out", Whole]);
        Assert.Equal("", FolderContent.Of(Out).DifferenceFrom(FolderContent.Of(Whole)));
    }

    private DateTime[] MaskTimes() => [.. Directory.GetFiles(Path.Combine(Out, FramePaths.Masks)).Order().Select(File.GetLastWriteTimeUtc)];

    private SessionRelabeller Relabeller(bool resume) =>
        new(
            new SessionReader(_inputs.Session),
            new RelabelOptions
            {
                RangeMetres = 60,
                Classes = [Sessions.Scenes.ObjectClass.Sign, Sessions.Scenes.ObjectClass.TrafficLight],
                Resume = resume,
            }
        );

    private void StopRelabel()
    {
        Mark(RelabelWords);
        using var stop = new CancellationTokenSource();
        Assert.Throws<OperationCanceledException>(() => Relabeller(resume: false).Run(Out, made => StopAt(made, stop), stop.Token));
    }

    /// <summary>The merge has no report of frames: it is stopped by a source that lacks its last frames, which then come.</summary>
    private void StopMerge()
    {
        Mark(MergeWords);
        string missing = Path.Combine(_inputs.Shards[0], "frames/00000004.png");
        File.Move(missing, missing + ".away");
        try
        {
            Assert.Throws<DatasetFormatException>(() => SessionMerger.Merge(_inputs.Shards, Out, new MergeOptions(ImageTransfer.Copy)));
        }
        finally
        {
            File.Move(missing + ".away", missing);
        }
    }

    private void Mark(string[] words)
    {
        Directory.CreateDirectory(Out);
        UnfinishedMark.Write(Out, CommandText.Of(words));
    }

    private static void StopAt(int made, CancellationTokenSource stop)
    {
        if (made == Finished)
        {
            stop.Cancel();
        }
    }

    /// <summary>A session with masks and scenes, and two shards of it.</summary>
    public sealed class Inputs : IDisposable
    {
        private readonly TemporaryFolder _folder = new();

        public Inputs()
        {
            File.WriteAllText(Roads, WritingCommand.Roads);
            Harvest(Session);
            Harvest(Shards[0], "--shard", "1/2");
            Harvest(Shards[1], "--shard", "2/2");
        }

        public string Roads => _folder.PathOf("roads.csv");

        public string Session => _folder.PathOf("session");

        public string[] Shards => [_folder.PathOf("part-1"), _folder.PathOf("part-2")];

        public void Dispose() => _folder.Dispose();

        private void Harvest(string folder, params string[] more) =>
            Run([
                "harvest",
                "--out",
                folder,
                "--frames",
                $"{Frames}",
                "--seed",
                "5",
                "--size",
                "64x48",
                "--masks",
                "--no-report",
                "--roads",
                Roads,
                .. more,
            ]);
    }
}
