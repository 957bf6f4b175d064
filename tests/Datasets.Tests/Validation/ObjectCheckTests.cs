using System.Text.Json.Nodes;
using Harvester.Datasets.Validation;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Objects whose boxes, fractions, distance or number cannot be.</summary>
public sealed class ObjectCheckTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Theory]
    [InlineData("[-1, 27, 43, 33]", "does not lie in the image")]
    [InlineData("[37, 27, 81, 33]", "does not lie in the image")]
    [InlineData("[37, 27, 43, 34]", "does not lie within box2dAmodal")]
    [InlineData("[43, 27, 37, 33]", "has no area")]
    [InlineData("[37, 27, 43, 27]", "has no area")]
    [Trait("Category", "Heavy")]
    public void Validate_finds_an_impossible_box(string box, string message)
    {
        _session.Car(2)["box2d"] = JsonNode.Parse(box);

        Assert.Contains(
            SessionValidator.Validate(_session.Open()).Problems,
            problem => problem.Line == 3 && problem.Message.Contains(message, StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Validate_finds_visible_pixels_outside_the_box()
    {
        _session.Car(0)["box2dVisible"] = JsonNode.Parse("[35, 27, 43, 33]");
        _session.PaintMask(0, 1, 35, 27, 43, 33);

        _session.AssertProblem(1, "box2dVisible [35, 27, 43, 33] does not lie within box2d");
    }

    [Fact]
    public void Validate_accepts_pixels_outside_the_box_in_an_imported_mask()
    {
        _session.Lines[0]["pixelMap"] = null;
        _session.Car(0)["occlusionMethod"] = "imported";
        _session.Car(0)["box2dVisible"] = JsonNode.Parse("[35, 27, 43, 33]");
        _session.PaintMask(0, 1, 35, 27, 43, 33);

        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
    }

    [Theory]
    [InlineData("truncatedFraction", -0.01)]
    [InlineData("truncatedFraction", 1.01)]
    [InlineData("occludedFraction", -0.01)]
    [InlineData("occludedFraction", 1.01)]
    public void Validate_finds_a_fraction_out_of_range(string field, double value)
    {
        _session.Car(0)[field] = value;
        _session.Car(0)["visibleFraction"] = 0.75 * (1 - value) / (field == "occludedFraction" ? 0.75 : 1);

        _session.AssertProblem(1, $"{field} is");
    }

    [Theory]
    [InlineData("0.9")]
    [InlineData("null")]
    public void Validate_finds_an_inconsistent_visible_fraction(string visible)
    {
        _session.Car(0)["visibleFraction"] = JsonNode.Parse(visible);

        _session.AssertProblem(1, $"visibleFraction is {visible}, but (1 - truncatedFraction)(1 - occludedFraction) is 0.75");
    }

    [Fact]
    public void Validate_finds_a_distance_that_contradicts_the_cuboid()
    {
        _session.Car(0)["distanceMetres"] = 12;

        _session.AssertProblem(1, "distanceMetres is 12, but box3d.centre is 11 m from the camera");
    }

    [Theory]
    [InlineData(0)]
    [InlineData(65536)]
    public void Validate_finds_an_id_that_no_mask_can_hold(int id)
    {
        _session.Lines[0]["objects"]![1]!["id"] = id;

        _session.AssertProblem(1, "ids are 1 to 65535");
    }
}
