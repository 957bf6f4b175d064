using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Bdd100K;

public sealed class Bdd100KCheckTests(SimulatedSession simulated) : CheckTests(simulated, "bdd100k")
{
    private const string Objects = "labels/det_20/det_train.json";
    private const string Lanes = "labels/lane/polygons/lane_train.json";

    [Theory]
    [InlineData("^\\{", "", "invalid JSON at ")]
    [InlineData("00000000.png", "00000099.png", "'00000099.png' is not in images/100k/train, or occurs twice.")]
    [InlineData("\"width\":200", "\"width\":201", "its image is 200 x 150, not 201 x 150.")]
    [InlineData("\"weather\":\"[^\"]*\"", "\"weather\":\"hail\"", "weather 'hail' is unknown.")]
    [InlineData("\"timeofday\":\"[^\"]*\"", "\"timeofday\":\"noon\"", "timeofday 'noon' is unknown.")]
    [InlineData("\"frameIndex\":0", "\"frameIndex\":null", "frameIndex must be a whole number, not null.")]
    public void A_damaged_frame_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Objects, pattern, replacement, $"{Objects}, line 2: {expected}");

    [Theory]
    [InlineData("\"x2\":[^,]*", "\"x2\":200", "its box does not lie in the image of 200 x 150, or has no area.")]
    [InlineData("\"y2\":[^}]*", "\"y2\":-2", "its box does not lie in the image of 200 x 150, or has no area.")]
    [InlineData("\"category\":\"[^\"]*\"", "\"category\":\"ship\"", "category 'ship' is unknown.")]
    [InlineData("\"trafficLightColor\":\"[^\"]*\"", "\"trafficLightColor\":\"blue\"", "trafficLightColor has an unknown value.")]
    public void A_damaged_label_is_found(string pattern, string replacement, string expected)
    {
        Export();
        Damage(Objects, pattern, replacement);
        Assert.Contains(
            Problems(),
            problem =>
                problem.StartsWith($"{Objects}, line ", StringComparison.Ordinal) && problem.EndsWith(expected, StringComparison.Ordinal)
        );
    }

    [Theory]
    [InlineData("\"types\":\"L", "\"types\":\"C", "types is not an L for each of two or more points.")]
    [InlineData("\"closed\":false", "\"closed\":true", "its line is closed.")]
    [InlineData("\"vertices\":\\[\\[[^,]*", "\"vertices\":[[201", "a point does not lie in the image of 200 x 150.")]
    [InlineData("\"laneStyle\":\"[^\"]*\"", "\"laneStyle\":\"dotted\"", "laneStyle is not solid or dashed.")]
    [InlineData("\"category\":\"[^\"]*\"", "\"category\":\"rope\"", "category 'rope' is unknown.")]
    public void A_damaged_marking_is_found(string pattern, string replacement, string expected)
    {
        Export();
        Damage(Lanes, pattern, replacement);
        Assert.Contains(
            Problems(),
            problem =>
                problem.StartsWith($"{Lanes}, line ", StringComparison.Ordinal) && problem.EndsWith(expected, StringComparison.Ordinal)
        );
    }

    [Fact]
    public void List_that_is_cut_off_or_missing_is_found()
    {
        Export();
        Damage(Objects, "^\\]\n", "");
        AssertFound($"{Objects}: it is cut off");
        Delete(Objects);
        AssertFound($"{Objects}: it is missing.");
        AssertFound("images/100k/train/00000006.png: it is not in " + Objects);
    }
}
