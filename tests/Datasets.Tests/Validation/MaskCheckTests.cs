using System.Text.Json.Nodes;
using Harvester.Datasets.Validation;
using Harvester.Sessions.Reading;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>
/// Masks that show something else than their labels say. The car, 1, is seen in [38, 28, 43, 33], the pedestrian, 2, nowhere.
/// </summary>
public sealed class MaskCheckTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Validate_finds_a_mask_that_shows_nothing()
    {
        _session.PaintMask(1, 0, 0, 0, 80, 60);

        _session.AssertProblem(2, "object 1: box2dVisible is [38, 28, 43, 33], but the bounds of its pixels in the mask are null");
    }

    [Fact]
    public void Visible_object_without_a_pixel_is_a_problem()
    {
        _session.PaintMask(0, 0, 0, 0, 80, 60);
        _session.Car(0)["box2dVisible"] = null;

        _session.AssertProblem(1, "object 1: visibleFraction is 0.75, but it has no pixel in the mask");
    }

    [Fact]
    public void Validate_finds_a_mask_value_without_an_object()
    {
        _session.PaintMask(0, 999, 38, 28, 43, 33);

        IReadOnlyList<SessionProblem> problems = SessionValidator.Validate(_session.Open()).Problems;

        Assert.Equal(2, problems.Count);
        Assert.Equal(
            "labels.jsonl, line 1: mask 'masks/00000000.png' has ids without an object in this line: 999.",
            problems[0].ToString()
        );
    }

    [Fact]
    public void Validate_finds_masks_that_are_swapped()
    {
        _session.Car(2)["box2dVisible"] = JsonNode.Parse("[37, 28, 43, 33]");
        _session.PaintMask(2, 1, 37, 28, 43, 33);
        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
        (_session.Lines[0]["mask"], _session.Lines[2]["mask"]) = ("masks/00000002.png", "masks/00000000.png");

        Assert.Equal([1, 3], SessionValidator.Validate(_session.Open()).Problems.Select(problem => problem.Line!.Value));
    }

    [Fact]
    public void Validate_finds_pixels_of_a_hidden_object()
    {
        _session.Car(0)["box2dVisible"] = null;

        _session.AssertProblem(1, "object 1: box2dVisible is null, but the bounds of its pixels in the mask are [38, 28, 43, 33]");
    }

    [Fact]
    public void Validate_finds_a_face_that_has_the_pixels_of_its_sign()
    {
        _session.AddSign(0);
        _session.PaintMask(0, (1, 38, 28, 43, 33), (4, 15, 15, 25, 25), (3, 19, 25, 21, 40));
        _session.Lines[0]["objects"]![2]!["box2dVisible"] = JsonNode.Parse("[19, 25, 21, 40]");
        _session.Lines[0]["objects"]![3]!["box2dVisible"] = JsonNode.Parse("[15, 15, 25, 25]");

        _session.AssertProblem(1, "object 4: the mask has its id, but it is a part; pixels of parts have the id of the whole object, 3.");
    }

    [Fact]
    public void Validate_finds_a_visible_face_on_an_invisible_sign()
    {
        _session.AddSign(0);
        _session.PaintMask(0, 1, 38, 28, 43, 33);
        JsonNode sign = _session.Lines[0]["objects"]![2]!;
        (sign["box2dVisible"], sign["occludedFraction"], sign["visibleFraction"]) = (null, 1, 0);

        _session.AssertProblem(1, "object 4: visibleFraction is 1, but its whole object, 3, has no pixel in the mask.");
    }

    /// <summary>As earlier versions imported the masks of other tools.</summary>
    [Fact]
    public void Validate_finds_an_imported_hidden_face_on_a_visible_sign()
    {
        _session.AddSign(0);
        JsonNode face = _session.Lines[0]["objects"]![3]!;
        (face["occludedFraction"], face["visibleFraction"], face["occlusionMethod"]) = (1, 0, "imported");

        _session.AssertProblem(1, "object 4: occludedFraction is 1, but the mask shows its whole object, 3, in its place.");
    }

    [Fact]
    public void Validate_finds_a_mask_of_damaged_pixels()
    {
        File.WriteAllBytes(_session.PathOf("masks/00000000.png"), TestImages.PngWithoutPixels(80, 60, bitDepth: 16, colourType: 0));

        _session.AssertProblem(1, "mask 'masks/00000000.png' cannot be used: its pixels are damaged.");
    }

    [Fact]
    public void Validate_finds_mask_values_in_a_label_without_a_mask()
    {
        _session.Lines[0]["mask"] = null;

        Assert.Equal(
            ["pixelMap is given without a mask.", "object 1: box2dVisible is given without a mask."],
            SessionValidator.Validate(_session.Open()).Problems.Select(problem => problem.Message)
        );
    }
}
