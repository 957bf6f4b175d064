using System.Text.Json.Nodes;
using Harvester.Datasets.Validation;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Ignore regions, and what a label says of its boxes.</summary>
public sealed class IgnoreRegionCheckTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Ignore_regions_are_read_back()
    {
        Mark("[60, 20, 70, 25]", 157.5);

        IgnoreRegion region = Assert.Single(_session.Open().ReadLabels().First().IgnoreRegions);

        Assert.Equal(new IgnoreRegion(IgnoreReason.BeyondRange, ObjectClass.Truck, new Box2D(60, 20, 70, 25), 157.5), region);
        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
    }

    [Theory]
    [InlineData("[60, 20, 81, 25]", 157, "ignoreRegions[0]: box2d [60, 20, 81, 25] does not lie in the image")]
    [InlineData("[60, 20, 60, 25]", 157, "ignoreRegions[0]: box2d [60, 20, 60, 25] has no area")]
    [InlineData("[60, 20, 70, 25]", -1, "ignoreRegions[0]: distanceMetres is -1")]
    public void Impossible_region_is_a_problem(string box, double distance, string message)
    {
        Mark(box, distance);

        _session.AssertProblem(1, message);
    }

    [Fact]
    public void Label_that_names_a_missing_box_is_a_problem()
    {
        _session.Lines[0]["objects"]![1]!["boxes"] = JsonNode.Parse("""["cuboid", "amodal", "visible"]""");

        _session.AssertProblem(1, "object 2: boxes is [cuboid, amodal, visible], but the label has [cuboid, amodal].");
    }

    private void Mark(string box, double distance) =>
        _session.Lines[0]["ignoreRegions"] = new JsonArray(
            new JsonObject
            {
                ["reason"] = "beyondRange",
                ["class"] = "truck",
                ["box2d"] = JsonNode.Parse(box),
                ["distanceMetres"] = distance,
            }
        );
}
