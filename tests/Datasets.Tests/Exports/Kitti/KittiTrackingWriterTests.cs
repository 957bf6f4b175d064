namespace Harvester.Datasets.Tests.Exports.Kitti;

public sealed class KittiTrackingWriterTests : ExportTests
{
    [Fact]
    public void Each_session_is_a_sequence_with_frames_and_track_ids()
    {
        Folder.Export("kitti-tracking", [Session.Open(), Session.Open()]);

        string[] lines = Folder.Lines("out/training/label_02/0001.txt");
        Assert.Equal(["0 1 Car", "0 2 Pedestrian", "1 1 Car", "1 2 Pedestrian", "2 1 Car", "2 2 Pedestrian"], lines.Select(line => string.Join(' ', line.Split(' ')[..3])));
        // 17 columns; truncation is a level here: 0.2 of the pedestrian is a part of it.
        Assert.All(lines, line => Assert.Equal(17, line.Split(' ').Length));
        Assert.Equal("1 3 -2.4469 69.5 23.5 79 35.5 2 2 0 6 1 5 -1.5708", string.Join(' ', lines[1].Split(' ')[3..]));
        Assert.True(File.Exists(Folder.PathOf("out/training/image_02/0001/000002.png")));
        Assert.StartsWith("P2: 30 0 39.5 0", Folder.Lines("out/training/calib/0000.txt")[2], StringComparison.Ordinal);
        Assert.Equal(["0000", "0001"], Folder.Lines("out/ImageSets/train.txt"));
    }

    [Fact]
    public void A_camera_that_changes_within_a_session_is_refused()
    {
        Session.Lines[1]["camera"]!["fx"] = 31;

        Assert.Contains("another calibration", Assert.Throws<DatasetFormatException>(() => Folder.Export("kitti-tracking", Session.Open())).Message, StringComparison.Ordinal);
    }
}
