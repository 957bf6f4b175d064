using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Kitti;

public sealed class KittiCheckTests(SimulatedSession simulated) : CheckTests(simulated, "kitti")
{
    private const string Label = "training/label_2/000001.txt";
    private const string Calibration = "training/calib/000002.txt";

    [Theory]
    [InlineData(" [^ ]+$", "", "it has 14 columns instead of 15.")]
    [InlineData("^[A-Za-z]+", "Lorry", "'Lorry' is not a type of KITTI.")]
    [InlineData("^((\\S+ ){2}\\S+) \\S+", "$1 x", "a column after the type is not a number.")]
    [InlineData("^(\\S+) \\S+", "$1 1.5", "truncated is not 0 to 1.")]
    [InlineData("^((\\S+ ){2})\\S+", "${1}4", "occluded is not 0, 1, 2 or 3.")]
    [InlineData("^((\\S+ ){3})\\S+", "${1}3.5", "alpha or rotation_y is not an angle")]
    [InlineData("^((\\S+ ){3})\\S+", "${1}0.123", "alpha is not rotation_y minus the direction of x and z.")]
    [InlineData("^((\\S+ ){6})\\S+", "${1}200", "its box does not lie in the image, or has no area.")]
    [InlineData("^((\\S+ ){8})\\S+", "${1}-1", "its height, width or length is below 0.")]
    [InlineData("^((\\S+ ){12})\\S+", "${1}90", "its 3D box, projected with P2, does not fall onto its 2D box.")]
    public void A_damaged_label_is_found_with_its_line(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Label, pattern, replacement, $"{Label}, line 1: {expected}");

    [Theory]
    [InlineData("^P1: .*\n", "", ": P1 is missing.")]
    [InlineData("^P0: \\S+", "P0:", ", line 1: P0 does not have 12 numbers.")]
    [InlineData("^P2: \\S+", "P2: -1", ", line 3: P2 is not the projection of a camera.")]
    [InlineData("^P3:", "P4:", ", line 4: 'P4:' is not a matrix of the format, or occurs twice.")]
    public void A_damaged_calibration_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Calibration, pattern, replacement, Calibration + expected);

    [Fact]
    public void A_calibration_of_another_camera_is_found()
    {
        Export();
        Damage(Calibration, "^P2: (\\S+) 0 \\S+", "P2: $1 0 400");
        AssertFound("training/label_2/000002.txt, line 1: its 3D box, projected with P2, does not fall onto its 2D box.");
    }

    [Theory]
    [InlineData(Label, Label + ": it is missing, but its image exists.")]
    [InlineData(Calibration, Calibration + ": P2 is missing.")]
    [InlineData("training/image_2/000003.png", "training/label_2/000003.txt: its image is missing.")]
    [InlineData("training/image_2/000003.png", "ImageSets/train.txt, line 4: '000003' is not in the dataset.")]
    [InlineData("training/image_2/000003.png", "export.json: it counts 7 frames in train, but the dataset has 6.")]
    [InlineData("ImageSets/train.txt", "ImageSets/*.txt: '000000' is not in any list.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);

    [Fact]
    public void A_frame_in_two_splits_is_found()
    {
        Export(TwoSplits);
        string frame = Folder.Lines("out/ImageSets/train.txt")[0];
        Damage("ImageSets/val.txt", "\\A", frame + "\n");
        AssertFound($"ImageSets/val.txt, line 1: '{frame}' was listed before, here or in another split.");
    }

    [Fact]
    public void Truncated_image_is_found()
    {
        Export();
        byte[] image = File.ReadAllBytes(Folder.PathOf("out/training/image_2/000005.png"));
        File.WriteAllBytes(Folder.PathOf("out/training/image_2/000005.png"), image[..^20]);
        AssertFound("training/image_2/000005.png: it is cut off");
    }
}
