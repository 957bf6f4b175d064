namespace Harvester.Datasets.Tests.Exports.Yolo;

public sealed class YoloCheckTests(SimulatedSession simulated) : CheckTests(simulated, "yolo")
{
    private const string Label = "labels/train/00000002.txt";

    [Theory]
    [InlineData("^\\S+", "10", "class 10 is not one of the 10 classes in data.yaml.")]
    [InlineData("^\\S+", "0.5", "class 0.5 is not one of the 10 classes in data.yaml.")]
    [InlineData(" \\S+$", " x", "a word is not a number.")]
    [InlineData(" \\S+$", " 1.1", "a place is not 0 to 1.")]
    [InlineData(" \\S+$", "", "a box has 4 numbers, not 3.")]
    [InlineData(" \\S+$", " 0", "its box does not lie in the image, or has no area.")]
    [InlineData("^(\\S+) \\S+", "$1 1", "its box does not lie in the image, or has no area.")]
    public void A_damaged_label_is_found_with_its_line(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Label, pattern, replacement, $"{Label}, line 1: {expected}");

    [Theory]
    [InlineData("^  9: .*\n", "", "data.yaml: it names 9 classes, but 10 were exported.")]
    [InlineData("^val: .*", "val: images/elsewhere", "data.yaml, line 3: there are no images in images/elsewhere.")]
    public void A_damaged_data_file_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound("data.yaml", pattern, replacement, expected);

    [Theory]
    [InlineData("data.yaml", "data.yaml: it is missing.")]
    [InlineData(Label, Label + ": it is missing, but its image is there.")]
    [InlineData("images/train/00000002.png", Label + ": its image is missing.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);

    [Fact]
    public void A_frame_in_two_splits_is_found()
    {
        Export(TwoSplits);
        string image = Directory.EnumerateFiles(Folder.PathOf("out/images/train")).Select(Path.GetFileName).Order().First()!;
        Copy($"images/train/{image}", $"images/val/{image}");
        AssertFound($"images/val/{image}: it is there twice, here or in another split.");
    }
}
