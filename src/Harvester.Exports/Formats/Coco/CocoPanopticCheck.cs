using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Coco;

/// <summary>
/// Checks COCO panoptic: one annotation per image, whose segments are the colours of the PNG, with their boxes and areas.
/// </summary>
internal static class CocoPanopticCheck
{
    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        var images = new CocoImages(dataset);
        return dataset.Splits.SelectMany(split => ProblemsOf(dataset, images, split));
    }

    private static List<SessionProblem> ProblemsOf(DatasetContent dataset, CocoImages images, string split)
    {
        string name = $"annotations/panoptic_{split}.json";
        List<SessionProblem> problems = [.. images.Read(name, split).Take(ProblemList.MaxProblems + 1)];
        if (!dataset.Has(name))
        {
            return problems;
        }

        var seen = new HashSet<long>();
        problems.AddRange(
            CocoElements
                .Problems(dataset, name, (list, element) => list == "annotations" ? Problem(dataset, split, element, images, seen) : null)
                .Take(ProblemList.MaxProblems + 1)
        );
        problems.AddRange(
            images.Sizes.Keys.Where(id => !seen.Contains(id)).Select(id => new SessionProblem(name, null, $"image {id} has no annotation."))
        );
        return problems;
    }

    private static string? Problem(DatasetContent dataset, string split, JsonFields annotation, CocoImages images, HashSet<long> seen)
    {
        long image = annotation.LongInteger("image_id");
        string picture = $"annotations/panoptic_{split}/{annotation.Text("file_name")}";
        string? problem =
            !images.Sizes.TryGetValue(image, out ImageSize size) ? "its image is not listed."
            : !seen.Add(image) ? "its image already has an annotation."
            : !dataset.Has(picture) ? $"'{picture}' is missing."
            : SegmentsProblem(annotation.List("segments_info"), PngDecoder.ReadRgb(dataset.PathOf(picture)), size, images);
        return problem is null ? null : $"annotation of image {image}: {problem}";
    }

    private static string? SegmentsProblem(IReadOnlyList<JsonFields> segments, PixelBuffer picture, ImageSize size, CocoImages images)
    {
        if (picture.Size != size)
        {
            return $"its map is {picture.Size.Width} x {picture.Size.Height}, not {size.Width} x {size.Height}.";
        }

        var found = new Dictionary<int, Segment>(new SegmentMap(picture).Segments);
        foreach (JsonFields segment in segments)
        {
            int id = segment.Integer("id");
            double[] box = segment.Numbers("bbox", 4);
            if (!found.Remove(id, out Segment? pixels))
            {
                return $"segment {id} is not in its map, or occurs twice.";
            }

            if (
                segment.Integer("area") != pixels.Area
                || !box.SequenceEqual([pixels.Left, pixels.Top, pixels.Right - pixels.Left, pixels.Bottom - pixels.Top])
            )
            {
                return $"area or bbox of segment {id} differs from its map.";
            }

            if (!images.HasCategory(segment.Integer("category_id")) || segment.Integer("iscrowd") is not (0 or 1))
            {
                return $"segment {id} has a category that is not listed, or an iscrowd that is not 0 or 1.";
            }
        }

        return found.Count == 0 ? null : $"segment {found.Keys.Min()} of its map is not listed.";
    }
}
