using Harvester.Exports.Validation;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Tests.Kitti;

public sealed class KittiTrackingWriterTests : ExportTests
{
    [Fact]
    public void Each_session_is_a_sequence_with_frames_and_track_ids()
    {
        Session.DeterminePedestrians();
        Folder.Export("kitti-tracking", [Session.Open(), Session.Open()]);

        string[] lines = Folder.Lines("out/training/label_02/0001.txt");
        Assert.Equal(
            ["0 1 Car", "0 2 Pedestrian", "1 1 Car", "1 2 Pedestrian", "2 1 Car", "2 2 Pedestrian"],
            lines.Select(line => string.Join(' ', line.Split(' ')[..3]))
        );
        // 17 columns; truncation is a level here: 0.2 of the pedestrian is a part of it.
        Assert.All(lines, line => Assert.Equal(17, line.Split(' ').Length));
        Assert.Equal("1 0 -2.4469 69.5 23.5 79 35.5 2 2 0 6 1 5 -1.5708", string.Join(' ', lines[1].Split(' ')[3..]));
        Assert.True(File.Exists(Folder.PathOf("out/training/image_02/0001/000002.png")));
        Assert.StartsWith("P2: 30 0 39.5 0", Folder.Lines("out/training/calib/0000.txt")[2], StringComparison.Ordinal);
        Assert.Equal(["0000", "0001"], Folder.Lines("out/ImageSets/train.txt"));
    }

    [Fact]
    public void Seqmap_lists_the_sequences_with_their_lengths()
    {
        Folder.Export(
            "kitti-tracking",
            [Session.Open(), Session.Open()],
            new ExportOptions { Splits = new SplitPlan([new("train", 0.5), new("val", 0.5)], 1, 1) }
        );

        Assert.Equal(
            ["0000 empty 000000 000003", "0001 empty 000000 000003"],
            Folder.Lines("out/training/evaluate_tracking.seqmap.training")
        );
        Assert.Equal(["0001 empty 000000 000003"], Folder.Lines("out/training/evaluate_tracking.seqmap.train"));
        Assert.Equal(["0000 empty 000000 000003"], Folder.Lines("out/training/evaluate_tracking.seqmap.val"));
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void Sequence_without_objects_has_an_empty_label_file()
    {
        Session.Lines.ForEach(line => line["objects"]!.AsArray().Clear());
        Folder.Export("kitti-tracking", Session.Open());

        Assert.Empty(Folder.Lines("out/training/label_02/0000.txt"));
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void A_camera_that_changes_within_a_session_is_refused()
    {
        Session.Lines[1]["camera"]!["fx"] = 31;

        Assert.Contains(
            "camera calibration differs",
            Assert.Throws<DatasetFormatException>(() => Folder.Export("kitti-tracking", Session.Open())).Message,
            StringComparison.Ordinal
        );
    }
}
