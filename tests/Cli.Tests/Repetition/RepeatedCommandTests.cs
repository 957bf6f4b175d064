using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>Commands that were stopped and are given again.</summary>
public sealed class RepeatedCommandTests : IDisposable
{
    private static readonly string[] Small = ["--seed", "5", "--size", "64x48", "--masks", "--no-report"];

    private readonly TemporaryFolder _folder = new();

    private string Out => _folder.PathOf("out");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Half_harvest_given_again_ends_as_if_undisturbed()
    {
        HalfHarvest();

        Assert.Equal((ExitCode.Done, ""), Ending(Harvest("out", "2")));

        Recorded("whole", "2");
        Assert.Equal(FolderContent.Of(_folder.PathOf("whole")), FolderContent.Of(Out));
    }

    [Fact]
    public void Half_harvest_is_not_replaced_by_another_command()
    {
        HalfHarvest();
        FolderContent stopped = FolderContent.Of(Out);

        Harvest("out", "3")
            .AssertFailed(
                ExitCode.Usage,
                $"'{Out}' has the unfinished result of 'harvester harvest --frames 2 --seed 5 --size 64x48 --masks --no-report'. "
                    + "Run that command again, name another folder with --out, or replace it with --overwrite."
            );

        Assert.Equal(stopped, FolderContent.Of(Out));
        Assert.Equal((ExitCode.Done, ""), Ending(Harvest("out", "3", "--overwrite")));
        Assert.Equal(3, new SessionReader(Out).ReadLabels().Count());
        Assert.Equal([Out], Directory.GetFileSystemEntries(_folder.Path));
    }

    [Theory]
    [InlineData("notes.txt")]
    [InlineData("frames/holiday.jpg")]
    [InlineData("scenes/copy of roads.csv")]
    public void Half_harvest_with_a_foreign_file_is_left_alone(string name)
    {
        HalfHarvest();
        File.WriteAllText(Path.Combine(Out, name), "mine");
        FolderContent stopped = FolderContent.Of(Out);

        Harvest("out", "2").AssertFailed(ExitCode.Usage, $"has other files besides a session, e.g. '{name}'");

        Assert.Equal(stopped, FolderContent.Of(Out));
    }

    [Fact]
    public void Harvest_stopped_while_marking_its_folder_starts_anew()
    {
        Directory.CreateDirectory(Out);
        File.WriteAllText(AtomicFile.TemporaryFor(Path.Combine(Out, UnfinishedMark.FileName)), "harv");

        Assert.Equal((ExitCode.Done, ""), Ending(Harvest("out", "1")));

        Assert.DoesNotContain(FolderContent.Of(Out).Names, UnfinishedMark.Is);
    }

    [Fact]
    public async Task Stopped_overwrite_keeps_the_session_that_was_there()
    {
        Recorded("out", "1");
        FolderContent former = FolderContent.Of(Out);

        using var stopped = new CancellationTokenSource();
        await stopped.CancelAsync();
        CliRun run = await CliRun.StartAsync("", stopped.Token, ["harvest", "--out", Out, .. Small, "--overwrite"]);

        Assert.Equal(ExitCode.Cancelled, run.ExitCode);
        Assert.Contains($"the session in '{Out}' is unchanged", run.Error, StringComparison.Ordinal);
        Assert.Equal(former, FolderContent.Of(Out));
        Assert.Equal([Out], Directory.GetFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void Failed_relabel_with_overwrite_keeps_the_former_session()
    {
        Recorded("recorded", "2");
        Recorded("out", "1");
        FolderContent former = FolderContent.Of(Out);
        File.Delete(_folder.PathOf("recorded/frames/00000001.png"));

        Relabel("--overwrite").AssertFailed(ExitCode.BadData, "00000001.png' is missing");

        Assert.Equal(former, FolderContent.Of(Out));
        Assert.Equal(2, Directory.GetFileSystemEntries(_folder.Path).Length);
    }

    [Fact]
    public void Failed_relabel_can_be_repeated()
    {
        Recorded("recorded", "2");
        string image = _folder.PathOf("recorded/frames/00000001.png");
        File.Move(image, image + ".away");
        Assert.Equal(ExitCode.BadData, Relabel().ExitCode);
        Assert.False(Directory.Exists(Out));
        File.Move(image + ".away", image);

        Assert.Equal((ExitCode.Done, ""), Ending(Relabel()));
    }

    [Fact]
    public void Killed_relabel_is_started_anew()
    {
        Recorded("recorded", "2");
        Relabel();
        FolderContent whole = FolderContent.Of(Out);
        UnfinishedMark.Write(Out, CommandText.Of(["relabel", _folder.PathOf("recorded"), "--no-report"]));
        File.Delete(Path.Combine(Out, "session.json"));
        File.WriteAllText(AtomicFile.TemporaryFor(Path.Combine(Out, "frames/00000001.png")), "half");

        Assert.Equal((ExitCode.Done, ""), Ending(Relabel()));

        Assert.Equal(whole, FolderContent.Of(Out));
    }

    [Fact]
    public void Merge_that_found_a_damaged_shard_can_be_repeated()
    {
        Recorded("1", "2", "--shard", "1/2");
        Recorded("2", "2", "--shard", "2/2");
        string labels = _folder.PathOf("2/labels.jsonl");
        string line = File.ReadAllText(labels);
        File.WriteAllText(labels, line.Replace("{\"frame\":1,", "{\"frame\":7,", StringComparison.Ordinal));
        string[] merge = ["merge", _folder.PathOf("1"), _folder.PathOf("2"), "--out", Out, "--no-report"];
        CliRun.Of(merge).AssertFailed(ExitCode.BadData, "has no frame 1");
        File.WriteAllText(labels, line);

        Assert.Equal((ExitCode.Done, ""), Ending(CliRun.Of(merge)));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Shard_that_was_stopped_is_not_merged()
    {
        Recorded("out", "2", "--shard", "1/2");
        UnfinishedMark.Write(Out, "harvester harvest");
        Recorded("2", "2", "--shard", "2/2");

        CliRun
            .Of("merge", Out, _folder.PathOf("2"), "--out", _folder.PathOf("merged"))
            .AssertFailed(ExitCode.BadData, "Shard 1/2 in '" + Out + "' is not finished. Run it again.");
    }

    [Fact]
    public void Failed_import_of_masks_keeps_the_session()
    {
        Recorded("out", "2");
        string maps = _folder.PathOf("maps");
        Directory.Move(Path.Combine(Out, "masks"), maps);

        // A folder where the second mask goes cannot be replaced by a file.
        Directory.CreateDirectory(Path.Combine(Out, "masks/00000001.png"));
        FolderContent former = FolderContent.Of(Out);

        Assert.Equal(ExitCode.InputOutput, CliRun.Of("masks", "import", Out, maps).ExitCode);

        Assert.Equal(former, FolderContent.Of(Out));
        Assert.Equal(2, Directory.GetFileSystemEntries(_folder.Path).Length);
    }

    [Fact]
    public void Import_of_masks_keeps_all_other_files()
    {
        Recorded("out", "1");
        string maps = _folder.PathOf("maps");
        Directory.CreateDirectory(maps);
        File.Copy(Path.Combine(Out, "masks/00000000.png"), Path.Combine(maps, "0.png"));
        Directory.CreateDirectory(Path.Combine(Out, "mine/empty"));
        File.WriteAllText(Path.Combine(Out, "mine/notes.txt"), "mine");
        string[] before = FolderContent.Of(Out).Names;

        Assert.Equal((ExitCode.Done, ""), Ending(CliRun.Of("masks", "import", Out, maps)));

        Assert.Equal(before, FolderContent.Of(Out).Names);
        Assert.True(Directory.Exists(Path.Combine(Out, "mine/empty")));
    }

    [Fact]
    public void Report_takes_away_what_a_killed_one_left()
    {
        Recorded("out", "1");
        string page = _folder.PathOf("page.html");
        File.WriteAllText(AtomicFile.TemporaryFor(page), "half");

        Assert.Equal((ExitCode.Done, ""), Ending(CliRun.Of("report", Out, "--out", page)));

        Assert.Equal([Out, page], Directory.GetFileSystemEntries(_folder.Path).Order(StringComparer.Ordinal));
    }

    private static (int Code, string Error) Ending(CliRun run) => (run.ExitCode, run.Error);

    /// <summary>What a harvest of two frames leaves that was killed while it wrote the second.</summary>
    private void HalfHarvest()
    {
        Recorded("out", "2");
        UnfinishedMark.Write(Out, "harvester harvest --frames 2 --seed 5 --size 64x48 --masks --no-report");
        string labels = Path.Combine(Out, "labels.jsonl");
        string first = File.ReadLines(labels).First();
        File.WriteAllText(labels, first + "\n" + first[..20]);
        File.WriteAllText(AtomicFile.TemporaryFor(Path.Combine(Out, "frames/00000001.png")), "half");
    }

    /// <summary>A session that was harvested before.</summary>
    private void Recorded(string name, string frames, params string[] more) =>
        SharedHarvest.CopyTo(_folder.PathOf(name), ["--frames", frames, .. Small, .. more]);

    private CliRun Harvest(string name, string frames, params string[] more) =>
        CliRun.Of(["harvest", "--out", _folder.PathOf(name), "--frames", frames, .. Small, .. more]);

    private CliRun Relabel(params string[] more) =>
        CliRun.Of(["relabel", _folder.PathOf("recorded"), "--out", Out, "--no-report", .. more]);
}
