using Harvester.Datasets.Files;
using Harvester.Datasets.Sharding;
using Harvester.Exports.Assembly;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>Exports and merges that were killed, at work or at their end: the same one resumes, another does not.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class InterruptedExportTests(SimulatedSession simulated) : ExportTests
{
    private static readonly ExportOptions TwoSplits = DatasetExporterTests.TwoSplits;

    [Theory]
    [MemberData(nameof(DatasetExporterTests.Formats), MemberType = typeof(DatasetExporterTests))]
    public void Killed_export_resumes(string format)
    {
        ExportOptions splits = DatasetExporterTests.SplitsOf(format);
        Folder.Export(format, simulated.OpenFor(format), splits, "single");
        KillAfter(3, format);

        var done = new List<int>();
        new DatasetExporter(ExportFolder.Plan(format, [simulated.OpenFor(format)], splits), Folder.PathOf("killed"), Shard.Whole).Run(
            done.Add
        );

        Assert.Equal(4, done[0]);
        Assert.Equal(Folder.Contents("single"), Folder.Contents("killed"));
    }

    [Fact]
    public void Frame_whose_file_has_changed_is_exported_again()
    {
        Folder.Export("voc", simulated.Open(), TwoSplits, "single");
        KillAfter(3, "voc");
        string[] written = [.. Directory.GetFiles(Folder.PathOf("killed/Annotations")).Order()];
        File.WriteAllText(written[1], File.ReadAllText(written[1]).Replace("<", "{", StringComparison.Ordinal));

        var done = new List<int>();
        new DatasetExporter(ExportFolder.Plan("voc", [simulated.Open()], TwoSplits), Folder.PathOf("killed"), Shard.Whole).Run(done.Add);

        Assert.Equal(2, done[0]);
        Assert.Equal(Folder.Contents("single"), Folder.Contents("killed"));
    }

    [Fact]
    public void Resumed_merge_copies_only_what_is_missing_or_damaged()
    {
        Folder.Export("voc", Session.Open(), to: "a", shard: new Shard(1, 2));
        Folder.Export("voc", Session.Open(), to: "b", shard: new Shard(2, 2));
        string[] shards = [Folder.PathOf("a"), Folder.PathOf("b")];
        DatasetMerger.Merge(shards, Folder.PathOf("whole"), new MergeOptions(ImageTransfer.Copy));
        string[] files = [.. Directory.GetFiles(Folder.PathOf("whole/Annotations")).Select(Path.GetFileName).OfType<string>().Order()];
        Directory.CreateDirectory(Folder.PathOf("out/.export"));
        Directory.CreateDirectory(Folder.PathOf("out/Annotations"));
        File.Copy(Folder.PathOf("a/.export/plan.json"), Folder.PathOf("out/.export/plan.json"));
        foreach (string file in files[..2])
        {
            File.Copy(Folder.PathOf("whole/Annotations/" + file), Folder.PathOf("out/Annotations/" + file));
            File.SetLastWriteTimeUtc(Folder.PathOf("out/Annotations/" + file), DateTime.UnixEpoch);
        }

        File.AppendAllText(Folder.PathOf("out/Annotations/" + files[1]), "damage");

        DatasetMerger.Merge(shards, Folder.PathOf("out"), new MergeOptions(ImageTransfer.Copy, Resume: true));

        Assert.Equal(DateTime.UnixEpoch, File.GetLastWriteTimeUtc(Folder.PathOf("out/Annotations/" + files[0])));
        Assert.NotEqual(DateTime.UnixEpoch, File.GetLastWriteTimeUtc(Folder.PathOf("out/Annotations/" + files[1])));
        Assert.Equal(Folder.Contents("whole"), Folder.Contents("out"));
    }

    [Fact]
    public void Export_does_not_resume_with_other_options()
    {
        KillAfter(2, "csv");

        OccupiedFolderException refused = Assert.Throws<OccupiedFolderException>(() =>
            Folder.Export("csv", simulated.Open(), to: "killed")
        );

        Assert.Contains("other sessions or options", refused.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"labels\":", "\"tables\":")]
    [InlineData("{\"frame\":1,", "{\"frame\":1.5,")]
    [InlineData("{\"frame\":1,", "{\"frame\":\"1\",")]
    [InlineData("{\"frame\":1,", "\u0000\u0000")]
    public void Export_does_not_resume_from_a_damaged_or_foreign_journal(string good, string bad)
    {
        KillAfter(2, "csv");
        string journal = Folder.PathOf("killed/.export/journal-1-of-1.jsonl");
        string text = File.ReadAllText(journal);
        Assert.Contains(good, text, StringComparison.Ordinal);
        File.WriteAllText(journal, text.Replace(good, bad, StringComparison.Ordinal));

        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() =>
            Folder.Export("csv", simulated.Open(), TwoSplits, "killed")
        );

        Assert.StartsWith($"'{journal}' has a damaged line", refused.Message, StringComparison.Ordinal);
        Assert.EndsWith("export again.", refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Export_killed_while_removing_its_working_folder_is_finished()
    {
        ExportResult whole = Folder.Export("csv", Session.Open());
        SortedDictionary<string, string> contents = Folder.Contents("out");
        Directory.CreateDirectory(Folder.PathOf("out/.export/parts"));
        File.WriteAllText(Folder.PathOf("out/.export/parts/0"), "left");

        Assert.Equivalent(whole, Folder.Export("csv", Session.Open()), strict: true);
        Assert.Equal(contents, Folder.Contents("out"));
    }

    [Fact]
    public void Merge_killed_while_removing_its_working_folder_is_finished()
    {
        Folder.Export("csv", Session.Open(), to: "a", shard: new Shard(1, 2));
        Folder.Export("csv", Session.Open(), to: "b", shard: new Shard(2, 2));
        string[] shards = [Folder.PathOf("a"), Folder.PathOf("b")];
        ExportResult whole = DatasetMerger.Merge(shards, shards[0], new MergeOptions(ImageTransfer.Link));
        SortedDictionary<string, string> contents = Folder.Contents("a");
        Directory.CreateDirectory(Folder.PathOf("a/.export"));

        Assert.Equivalent(whole, DatasetMerger.Merge(shards, shards[0] + "/", new MergeOptions(ImageTransfer.Link)), strict: true);
        Assert.Equal(contents, Folder.Contents("a"));
        Assert.False(Directory.Exists(Folder.PathOf("a/.export")));
    }

    [Fact]
    public void Export_or_merge_with_another_plan_does_not_finish_the_killed()
    {
        Folder.Export("csv", Session.Open());
        Directory.CreateDirectory(Folder.PathOf("out/.export"));
        Folder.Export("voc", Session.Open(), to: "shards", shard: new Shard(1, 2));
        Folder.Export("voc", Session.Open(), to: "shards", shard: new Shard(2, 2));

        Assert.Throws<OccupiedFolderException>(() => Folder.Export("voc", Session.Open()));
        Assert.Throws<OccupiedFolderException>(() =>
            DatasetMerger.Merge([Folder.PathOf("shards")], Folder.PathOf("out"), new MergeOptions(ImageTransfer.Link))
        );
    }

    [Fact]
    public void Export_does_not_resume_with_a_different_session()
    {
        KillAfter(2, "csv");
        string other = Folder.PathOf("other/" + Path.GetFileName(simulated.Folder));
        Directory.CreateDirectory(other);
        File.Copy(Path.Combine(simulated.Folder, "labels.jsonl"), Path.Combine(other, "labels.jsonl"));
        File.WriteAllText(Path.Combine(other, "session.json"), File.ReadAllText(Path.Combine(simulated.Folder, "session.json")) + "\n");

        OccupiedFolderException refused = Assert.Throws<OccupiedFolderException>(() =>
            Folder.Export("csv", new SessionReader(other), TwoSplits, "killed")
        );

        Assert.Contains("other sessions or options", refused.Message, StringComparison.Ordinal);
    }

    /// <summary>Leaves what a process that was killed while it wrote leaves: some frames, and half a line in the journal.</summary>
    private void KillAfter(int frames, string format)
    {
        using var stop = new CancellationTokenSource();
        var exporter = new DatasetExporter(
            ExportFolder.Plan(format, [simulated.OpenFor(format)], DatasetExporterTests.SplitsOf(format)),
            Folder.PathOf("killed"),
            Shard.Whole
        );
        Assert.Throws<OperationCanceledException>(() =>
            exporter.Run(
                done =>
                {
                    if (done == frames)
                    {
                        stop.Cancel();
                    }
                },
                stop.Token
            )
        );
        File.AppendAllText(Folder.PathOf("killed/.export/journal-1-of-1.jsonl"), "{\"frame\":3,\"split\":\"tra");
    }
}
