using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>
/// Joins the runs of a line that leaves the image and returns. A line whose paint is interrupted within the image stays in pieces.
/// </summary>
internal static class WholeLines
{
    /// <summary>Pixels have three decimals.</summary>
    private const double RoundingPixels = 0.002;

    /// <summary>The joined lines of an image.</summary>
    /// <param name="runs">The runs; those of a line from near to far.</param>
    /// <param name="image">The image, pixels.</param>
    public static IEnumerable<LaneLineView> Of(IEnumerable<LaneLineView> runs, Box2D image)
    {
        var lines = new List<LaneLineView>();
        foreach (LaneLineView run in runs)
        {
            int last = lines.FindLastIndex(line =>
                line.Index == run.Index && line.IsLeftOfCar == run.IsLeftOfCar && line.Paint == run.Paint
            );
            if (last >= 0 && IsOnBorder(lines[last].Points[^1], image) && IsOnBorder(run.Points[0], image))
            {
                lines[last] = lines[last] with { Points = [.. lines[last].Points.Concat(run.Points)] };
            }
            else
            {
                lines.Add(run);
            }
        }

        return lines;
    }

    private static bool IsOnBorder(LaneLinePoint point, Box2D image) =>
        new[] { point.Pixel.X - image.XMin, point.Pixel.Y - image.YMin, image.XMax - point.Pixel.X, image.YMax - point.Pixel.Y }.Min()
        <= RoundingPixels;
}
