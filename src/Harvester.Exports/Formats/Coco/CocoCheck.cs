using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Coco;

/// <summary>Checks COCO instances: ids are unique and known, boxes lie in their images, segmentations agree with box and area.</summary>
internal static class CocoCheck
{
    /// <summary>Boxes are rounded to three decimals.</summary>
    private const double RoundingPixels = 0.002;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        var images = new CocoImages(dataset);
        return dataset.Splits.SelectMany(split => ProblemsOf(dataset, images, split));
    }

    private static IEnumerable<SessionProblem> ProblemsOf(DatasetContent dataset, CocoImages images, string split)
    {
        BoxKind boxes = dataset.Options.Boxes ?? BoxKind.Cuboid;
        string name = $"annotations/instances_{split}.json";
        SessionProblem[] problems = [.. images.Read(name, split).Take(ProblemList.MaxProblems + 1)];
        var ids = new HashSet<long>();
        return dataset.Has(name)
            ? problems.Concat(
                CocoElements.Problems(dataset, name, (list, element) => list == "annotations" ? Problem(element, images, ids, boxes) : null)
            )
            : problems;
    }

    private static string? Problem(JsonFields annotation, CocoImages images, HashSet<long> ids, BoxKind boxes)
    {
        long id = annotation.LongInteger("id");
        string? problem =
            !ids.Add(id) || id < 1 ? "its id occurs twice or is below 1."
            : !images.Sizes.TryGetValue(annotation.LongInteger("image_id"), out ImageSize image) ? "its image is not listed."
            : !images.HasCategory(annotation.Integer("category_id")) ? "its category is not listed."
            : annotation.Integer("iscrowd") is not (0 or 1) ? "iscrowd is not 0 or 1."
            : ShapeProblem(annotation, image, boxes);
        return problem is null ? null : $"annotation {id}: {problem}";
    }

    private static string? ShapeProblem(JsonFields annotation, ImageSize image, BoxKind boxes)
    {
        double[] sides = annotation.Numbers("bbox", 4);
        var box = new Box2D(sides[0], sides[1], sides[0] + sides[2], sides[1] + sides[3]);
        double area = annotation.Number("area");
        bool isInImage = boxes == BoxKind.Amodal || new Box2D(0, 0, image.Width, image.Height).Contains(box, RoundingPixels);
        return !(box.Width > 0 && box.Height > 0 && isInImage)
                ? $"its box does not lie in the image of {image.Width} x {image.Height}, or has no area."
            : !(area > 0 && area <= MaxArea(box)) ? "its area is not positive, or larger than its box."
            : annotation.IsList("segmentation")
                ? CocoSegmentationCheck.PolygonProblem(annotation.Rows("segmentation"), SpannedBy(annotation, box, boxes), area)
            : CocoSegmentationCheck.RunsProblem(annotation.Fields("segmentation"), image, SpannedBy(annotation, box, boxes), area);
    }

    /// <summary>
    /// The box that a segmentation must span: the box around the visible pixels. Other boxes may be larger than their visible part.
    /// </summary>
    private static Box2D? SpannedBy(JsonFields annotation, Box2D box, BoxKind boxes) =>
        boxes == BoxKind.Visible && annotation.Integer("iscrowd") == 0 ? box : null;

    /// <summary>Largest area of a box's pixels: they reach beyond the box by less than one pixel on each side.</summary>
    private static double MaxArea(Box2D box) => (box.Width + 2) * (box.Height + 2);
}
