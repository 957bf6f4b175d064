using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Yolo;

public sealed class YoloCheckTests(SimulatedSession simulated) : CheckTests(simulated, "yolo")
{
    private const string Label = "labels/train/00000002.txt";

    private static readonly int Classes = Enum.GetValues<ObjectClass>().Length;

    public static TheoryData<string> NoClasses => [$"{Classes}", "0.5"];

    [Theory]
    [MemberData(nameof(NoClasses))]
    public void Unknown_class_is_found(string word) =>
        AssertDamageIsFound(Label, "^\\S+", word, $"{Label}, line 1: class {word} is not one of the {Classes} classes in data.yaml.");

    [Theory]
    [InlineData(" \\S+$", " x", "a value is not a number.")]
    [InlineData(" \\S+$", " 1.1", "a coordinate is not 0 to 1.")]
    [InlineData(" \\S+$", "", "a box has 4 numbers, not 3.")]
    [InlineData(" \\S+$", " 0", "its box does not lie in the image, or has no area.")]
    [InlineData("^(\\S+) \\S+", "$1 1", "its box does not lie in the image, or has no area.")]
    public void A_damaged_label_is_found_with_its_line(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Label, pattern, replacement, $"{Label}, line 1: {expected}");

    [Fact]
    public void Missing_class_name_is_found() =>
        AssertDamageIsFound(
            "data.yaml",
            $"^  {Classes - 1}: .*\n",
            "",
            $"data.yaml: it names {Classes - 1} classes, but {Classes} were exported."
        );

    [Fact]
    public void Split_without_images_is_found() =>
        AssertDamageIsFound(
            "data.yaml",
            "^val: .*",
            "val: images/elsewhere",
            "data.yaml, line 3: there are no images in images/elsewhere."
        );

    [Theory]
    [InlineData("data.yaml", "data.yaml: it is missing.")]
    [InlineData(Label, Label + ": it is missing, but its image exists.")]
    [InlineData("images/train/00000002.png", Label + ": its image is missing.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);

    [Fact]
    public void A_frame_in_two_splits_is_found()
    {
        Export(TwoSplits);
        string image = Directory.EnumerateFiles(Folder.PathOf("out/images/train")).Select(Path.GetFileName).Order().First()!;
        Copy($"images/train/{image}", $"images/val/{image}");
        AssertFound($"images/val/{image}: it occurs twice, here or in another split.");
    }
}
