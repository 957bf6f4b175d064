using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Lanes;

public sealed class TuSimpleCheckTests(SimulatedSession simulated) : CheckTests(simulated, "tusimple")
{
    private const string Labels = "label_data_train.json";

    [Theory]
    [InlineData("^\\{", "", "invalid JSON at ")]
    [InlineData("\"lanes\"", "\"lines\"", "lanes is missing.")]
    [InlineData("\"lanes\":\\[\\[[^,]*,", "\"lanes\":[[", "a lane does not have 10 columns")]
    [InlineData("\"lanes\":\\[\\[[^,]*,", "\"lanes\":[[200,", "a lane has a column that is neither -2 nor one of the image of 200 x 150.")]
    [InlineData("\"lanes\":\\[\\[[^,]*,", "\"lanes\":[[-1,", "a lane has a column that is neither -2 nor one of the image of 200 x 150.")]
    [InlineData("\"lanes\":\\[\\[[^\\]]*", "\"lanes\":[[-2,-2,-2,-2,-2,-2,-2,-2,-2,-2", "a lane has no points.")]
    [InlineData("\"h_samples\":\\[\\d+", "\"h_samples\":[90", "h_samples are not rising rows of the image of 200 x 150.")]
    [InlineData("140\\],\"raw_file\"", "150],\"raw_file\"", "h_samples are not rising rows of the image of 200 x 150.")]
    [InlineData("clips/0000/", "clips/0007/", "raw_file 'clips/0007/")]
    public void A_damaged_line_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Labels, pattern, replacement, $"{Labels}, line 1: {expected}");

    [Fact]
    public void A_frame_in_two_lines_is_found()
    {
        Export();
        Damage(Labels, "^(.*\n)", "$1$1");
        AssertFound($"{Labels}, line 2: raw_file 'clips/0000/");
    }

    [Fact]
    public void Image_without_labels_and_missing_labels_are_found()
    {
        Export();
        Delete(Labels);
        AssertFound($"{Labels}: it is missing.");
        AssertFound("clips/0000/00000006.png: it is not in any list of labels.");
    }
}
