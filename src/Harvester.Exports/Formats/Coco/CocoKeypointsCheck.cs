using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Coco;

/// <summary>Checks COCO keypoints: ids are unique and known, boxes and keypoints lie in their images, and keypoints are counted.</summary>
internal static class CocoKeypointsCheck
{
    /// <summary>Coordinates are rounded to three decimals.</summary>
    private const double RoundingPixels = 0.002;

    private const int NumbersOfAPoint = 3;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        var images = new CocoImages(dataset);
        return dataset.Splits.SelectMany(split => ProblemsOf(dataset, images, split));
    }

    private static IEnumerable<SessionProblem> ProblemsOf(DatasetContent dataset, CocoImages images, string split)
    {
        string name = $"annotations/person_keypoints_{split}.json";
        SessionProblem[] problems = [.. images.Read(name, split).Take(ProblemList.MaxProblems + 1)];
        var ids = new HashSet<long>();
        return dataset.Has(name)
            ? problems.Concat(
                CocoElements.Problems(dataset, name, (list, element) => list == "annotations" ? Problem(element, images, ids) : null)
            )
            : problems;
    }

    private static string? Problem(JsonFields annotation, CocoImages images, HashSet<long> ids)
    {
        long id = annotation.LongInteger("id");
        string? problem =
            !ids.Add(id) || id < 1 ? "its id occurs twice or is below 1."
            : !images.Sizes.TryGetValue(annotation.LongInteger("image_id"), out ImageSize image) ? "its image is not listed."
            : !images.HasCategory(annotation.Integer("category_id")) ? "its category is not listed."
            : annotation.Integer("iscrowd") is not (0 or 1) ? "iscrowd is not 0 or 1."
            : annotation.Number("area") <= 0 ? "its area is not positive."
            : PlaceProblem(annotation, new Box2D(0, 0, image.Width, image.Height));
        return problem is null ? null : $"annotation {id}: {problem}";
    }

    private static string? PlaceProblem(JsonFields annotation, Box2D image)
    {
        double[] sides = annotation.Numbers("bbox", 4);
        var box = new Box2D(sides[0], sides[1], sides[0] + sides[2], sides[1] + sides[3]);
        double[] numbers = annotation.Numbers("keypoints", CocoKeypoints.Count * NumbersOfAPoint);
        (double X, double Y, double Flag)[] points = [.. numbers.Chunk(NumbersOfAPoint).Select(point => (point[0], point[1], point[2]))];
        return !(box.Width > 0 && box.Height > 0 && image.Contains(box, RoundingPixels))
                ? "its box does not lie in the image, or has no area."
            : points.Any(point => point.Flag is not (CocoKeypoints.Absent or CocoKeypoints.Hidden or CocoKeypoints.Visible))
                ? "the flag of a keypoint is not 0, 1 or 2."
            : points.Any(point => point is { Flag: CocoKeypoints.Absent } and not { X: 0, Y: 0 })
                ? "a keypoint that is not labelled is not at 0, 0."
            : points.Any(point =>
                point.Flag != CocoKeypoints.Absent && !image.Contains(new Box2D(point.X, point.Y, point.X, point.Y), RoundingPixels)
            )
                ? "a keypoint does not lie in the image."
            : annotation.Integer("num_keypoints") != points.Count(point => point.Flag != CocoKeypoints.Absent)
                ? "num_keypoints is not the number of labelled keypoints."
            : null;
    }
}
