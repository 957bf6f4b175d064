using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Yolo;

public sealed class YoloOutlineCheckTests(SimulatedSession simulated) : CheckTests(simulated, "yolo-segment")
{
    private const string Label = "labels/train/00000002.txt";

    [Theory]
    [InlineData(" \\S+$", "", "an outline has two numbers for each of three corners or more, not ")]
    [InlineData("^(\\S+ \\S+ \\S+ \\S+ \\S+) .*", "$1", "an outline has two numbers for each of three corners or more, not 4.")]
    [InlineData("^(\\S+) .*", "$1 0.1 0.2 0.3 0.2 0.5 0.2", "its outline has no area.")]
    [InlineData(" \\S+$", " -0.1", "a coordinate is not 0 to 1.")]
    public void A_damaged_label_is_found_with_its_line(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Label, pattern, replacement, $"{Label}, line 1: {expected}");
}
