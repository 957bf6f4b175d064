using Harvester.Datasets.Files;
using Harvester.Exports.Assembly;
using Harvester.Sessions.Files;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>When a frame becomes part of an export, and which shards may share a folder.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class ExportSyncTests(SimulatedSession simulated) : ExportTests
{
    private string Journal => Folder.PathOf("out/.export/journal-1-of-1.jsonl");

    [Theory]
    [InlineData(SyncMode.Always, 1)]
    [InlineData(SyncMode.Batch, 0)]
    [InlineData(SyncMode.Never, 1)]
    public void First_line_is_written_when_its_batch_is(SyncMode sync, int expected)
    {
        var lines = new List<int>();

        Export(sync, _ => lines.Add(ReadJournal().Count(character => character == '\n')));

        Assert.Equal(expected, lines[0]);
    }

    [Fact]
    public void Frame_whose_file_cannot_be_flushed_has_no_line()
    {
        Assert.Throws<FileNotFoundException>(() =>
            Export(SyncMode.Batch, _ => File.Delete(Folder.PathOf("out/labels/train/00000000.txt")))
        );

        Assert.Equal("", ReadJournal());
    }

    [Fact]
    public void Stopped_export_keeps_the_frames_of_its_batch()
    {
        using var stop = new CancellationTokenSource();
        Assert.Throws<OperationCanceledException>(() => Export(SyncMode.Batch, _ => stop.Cancel(), stop.Token));

        Assert.StartsWith("{\"frame\":0,", ReadJournal(), StringComparison.Ordinal);
        Assert.EndsWith("\n", ReadJournal(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(1, 2, 1, 3, "has shard 1/2, so shard 1/3 goes to another folder. Name another with --out.")]
    [InlineData(1, 2, 1, 1, "has shard 1/2, so all frames go to another folder. Name another with --out.")]
    public void Folder_takes_shards_of_one_division(int number, int count, int otherNumber, int otherCount, string message)
    {
        Folder.Export("yolo", simulated.Open(), shard: new Shard(number, count));
        SortedDictionary<string, string> before = Folder.Contents("out");

        OccupiedFolderException refused = Assert.Throws<OccupiedFolderException>(() =>
            Folder.Export("yolo", simulated.Open(), shard: new Shard(otherNumber, otherCount))
        );

        Assert.EndsWith(message, refused.Message, StringComparison.Ordinal);
        Assert.Equal(before, Folder.Contents("out"));
    }

    [Fact]
    public void Shard_is_refused_in_the_folder_of_a_stopped_whole_export()
    {
        using var stop = new CancellationTokenSource();
        Assert.Throws<OperationCanceledException>(() => Export(SyncMode.Batch, _ => stop.Cancel(), stop.Token));

        OccupiedFolderException refused = Assert.Throws<OccupiedFolderException>(() =>
            Folder.Export("yolo", simulated.Open(), shard: new Shard(2, 2))
        );

        Assert.EndsWith(
            "has the unfinished export of all frames, so shard 2/2 goes to another folder. Name another with --out.",
            refused.Message,
            StringComparison.Ordinal
        );
    }

    private void Export(SyncMode sync, Action<int> report, CancellationToken cancellation = default) =>
        new DatasetExporter(ExportFolder.Plan("yolo", [simulated.Open()]), Folder.PathOf("out"), Shard.Whole, sync).Run(
            report,
            cancellation
        );

    /// <summary>The journal's text, while the export has it open.</summary>
    private string ReadJournal()
    {
        using var file = new FileStream(Journal, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        using var reader = new StreamReader(file);
        return reader.ReadToEnd();
    }
}
