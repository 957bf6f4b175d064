using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>The least convex polygon around points (Andrew's monotone chain).</summary>
internal static class ConvexHull
{
    /// <summary>Its corners, counter-clockwise.</summary>
    public static IReadOnlyList<Vector2D> Of(IEnumerable<Vector2D> points)
    {
        Vector2D[] sorted = [.. points.Distinct().OrderBy(point => point.X).ThenBy(point => point.Y)];
        return sorted.Length < 3 ? sorted : [.. Half(sorted), .. Half(sorted.Reverse())];
    }

    /// <summary>The corners on the right of the way from the first point to the last, without the last.</summary>
    private static IEnumerable<Vector2D> Half(IEnumerable<Vector2D> points)
    {
        var corners = new List<Vector2D>();
        foreach (Vector2D point in points)
        {
            while (corners.Count >= 2 && (corners[^1] - corners[^2]).Cross(point - corners[^1]) <= 0)
            {
                corners.RemoveAt(corners.Count - 1);
            }

            corners.Add(point);
        }

        return corners.SkipLast(1);
    }
}
