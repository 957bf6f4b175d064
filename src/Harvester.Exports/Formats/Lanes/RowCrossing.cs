using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>Where a line crosses a row of pixels.</summary>
internal static class RowCrossing
{
    /// <summary>
    /// The place at which a line crosses the middle of a row, pixels from the left side of the image; null if it does not. If it crosses
    /// twice, the nearer place.
    /// </summary>
    /// <param name="views">The runs of the line.</param>
    /// <param name="row">The row, from 0.</param>
    public static double? Of(IEnumerable<LaneLineView> views, int row)
    {
        double y = row + 0.5;
        foreach (LaneLineView view in views)
        {
            for (int i = 1; i < view.Points.Count; i++)
            {
                Vector2D a = view.Points[i - 1].Pixel;
                Vector2D b = view.Points[i].Pixel;
                if (a.Y != b.Y && Math.Min(a.Y, b.Y) <= y && y <= Math.Max(a.Y, b.Y))
                {
                    return a.X + ((b.X - a.X) * (y - a.Y) / (b.Y - a.Y));
                }
            }
        }

        return null;
    }
}
