using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Kitti;

public sealed class KittiTrackingCheckTests(SimulatedSession simulated) : CheckTests(simulated, "kitti-tracking")
{
    private const string Labels = "training/label_02/0000.txt";

    [Theory]
    [InlineData("^\\S+", "77", "frame 77 has no image.")]
    [InlineData("^((\\S+ ){3})\\S+", "${1}3", "truncated is not 0, 1 or 2.")]
    [InlineData("^((\\S+ ){4})\\S+", "${1}5", "occluded is not 0, 1, 2 or 3.")]
    [InlineData(" [^ ]+$", "", "it has 16 columns instead of 17.")]
    [InlineData("^(\\S+) \\S+", "$1 x", "a column other than the type is not a number.")]
    [InlineData("^((\\S+ ){14})\\S+", "${1}90", "its 3D box, projected with P2, does not fall onto its 2D box.")]
    public void A_damaged_label_is_found_with_its_line(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Labels, pattern, replacement, $"{Labels}, line 1: {expected}");

    [Fact]
    public void Duplicate_track_is_found()
    {
        Export();
        Damage(Labels, "^(.*\n)", "$1$1");
        AssertFound($"{Labels}, line 2: track ");
    }

    [Fact]
    public void A_track_that_changes_its_type_is_found()
    {
        Export();
        string[] words = Folder.Lines("out/" + Labels).Select(line => line.Split(' ')).First(line => line[2] == "Car");
        Damage(Labels, $"^1 {words[1]} Car", $"1 {words[1]} Truck");
        Assert.Contains(
            Problems(),
            problem => problem.EndsWith($"track {words[1]} is Truck, but was Car in an earlier frame.", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Frames_in_descending_order_are_found()
    {
        Export();
        string first = Folder.Lines("out/" + Labels)[0];
        File.AppendAllText(Folder.PathOf("out/" + Labels), first + "\n");
        Assert.Contains(Problems(), problem => problem.EndsWith(": frame 0 comes after frame 6.", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("training/calib/0000.txt", "training/calib/0000.txt: P2 is missing.")]
    [InlineData("training/label_02/0000.txt", "training/label_02/0000.txt: it is missing, but its image exists.")]
    [InlineData(
        "training/evaluate_tracking.seqmap.training",
        "training/evaluate_tracking.seqmap.training: it has no line '0000 empty 000000 000007'."
    )]
    [InlineData("ImageSets/train.txt", "ImageSets/*.txt: '0000' is not in any list.")]
    [InlineData("training/image_02/0000/000006.png", "export.json: it counts 7 frames in train, but the dataset has 6.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);
}
