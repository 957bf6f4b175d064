using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Coco;

/// <summary>Checks a segmentation: it spans its box, and run lengths fill the image and add up to the area.</summary>
internal static class CocoSegmentationCheck
{
    /// <summary>Polygons run along pixel borders, and so do the boxes around visible pixels.</summary>
    private const double RoundingPixels = 0.002;

    /// <summary>Polygons along pixel borders, whose areas add up to the number of pixels; empty without a mask.</summary>
    public static string? PolygonProblem(double[][] polygons, Box2D? box, double area)
    {
        if (polygons.Any(polygon => polygon.Length < 6 || polygon.Length % 2 != 0))
        {
            return "a polygon does not have three corners or more, two numbers each.";
        }

        double[] xs = [.. polygons.SelectMany(polygon => polygon.Where((_, i) => i % 2 == 0))];
        double[] ys = [.. polygons.SelectMany(polygon => polygon.Where((_, i) => i % 2 == 1))];
        return polygons.Length == 0 ? null
            : !IsSame(box, new Box2D(xs.Min(), ys.Min(), xs.Max(), ys.Max())) ? "its polygons do not span its box."
            : polygons.Sum(AreaOf) != area ? "its polygons do not have its area."
            : null;
    }

    /// <summary>The shoelace formula: half the sum of x1 y2 - x2 y1 over the sides. Corners are whole numbers, so it is exact.</summary>
    private static double AreaOf(double[] polygon)
    {
        double sum = 0;
        for (int i = 0; i < polygon.Length; i += 2)
        {
            int next = (i + 2) % polygon.Length;
            sum += (polygon[i] * polygon[next + 1]) - (polygon[next] * polygon[i + 1]);
        }

        return Math.Abs(sum) / 2;
    }

    /// <summary>Uncompressed run lengths, by column, beginning with the background.</summary>
    public static string? RunsProblem(JsonFields segmentation, ImageSize image, Box2D? box, double area)
    {
        double[] size = segmentation.Numbers("size", 2);
        double[] counts = segmentation.Numbers("counts");
        if (
            size[0] != image.Height
            || size[1] != image.Width
            || counts.Any(count => count < 0 || count != Math.Floor(count))
            || counts.Sum() != image.PixelCount
        )
        {
            return $"its run lengths are not those of an image of {image.Width} x {image.Height}.";
        }

        return counts.Where((_, i) => i % 2 == 1).Sum() != area ? "its run lengths do not add up to its area."
            : IsSame(box, BoxOf(counts, image.Height)) ? null
            : "its run lengths do not span its box.";
    }

    private static Box2D BoxOf(double[] counts, int height)
    {
        (int left, int top, int right, int bottom) = (int.MaxValue, int.MaxValue, 0, 0);
        int at = 0;
        for (int i = 0; i < counts.Length; i++)
        {
            int end = at + (int)counts[i];
            if (i % 2 == 1 && end > at)
            {
                // A run that continues in the next column touches the last row and the first.
                bool isInOneColumn = at / height == (end - 1) / height;
                left = Math.Min(left, at / height);
                right = Math.Max(right, ((end - 1) / height) + 1);
                top = isInOneColumn ? Math.Min(top, at % height) : 0;
                bottom = isInOneColumn ? Math.Max(bottom, ((end - 1) % height) + 1) : height;
            }

            at = end;
        }

        return new Box2D(left, top, right, bottom);
    }

    private static bool IsSame(Box2D? expected, Box2D found) =>
        expected is not { } box || (box.Contains(found, RoundingPixels) && found.Contains(box, RoundingPixels));
}
