using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>Draws lines as maps of their numbers.</summary>
internal static class LaneMap
{
    private const double HalfWidthPixels = 8;

    /// <summary>
    /// A map in which the pixels of each line have the number of its place, from 1, and all others 0. Where lines overlap, the last counts.
    /// </summary>
    /// <param name="size">Size of the image.</param>
    /// <param name="lines">Points of the lines, in pixels with integer centres; null for none.</param>
    public static InstanceMap Of(ImageSize size, IReadOnlyList<Vector2D[]?> lines)
    {
        var map = new InstanceMap(size);
        for (int place = 0; place < lines.Count; place++)
        {
            Vector2D[] points = lines[place] ?? [];
            for (int i = 1; i < points.Length; i++)
            {
                Draw(map, points[i - 1], points[i], (ushort)(place + 1));
            }
        }

        return map;
    }

    private static void Draw(InstanceMap map, Vector2D start, Vector2D end, ushort number)
    {
        Vector2D along = end - start;
        double lengthSquared = along.Dot(along);
        (int left, int right) = Range(start.X, end.X, map.Image.Width);
        (int top, int bottom) = Range(start.Y, end.Y, map.Image.Height);
        for (int row = top; row <= bottom; row++)
        {
            for (int column = left; column <= right; column++)
            {
                Vector2D away = new Vector2D(column, row) - start;
                double share = Math.Clamp(away.Dot(along) / lengthSquared, 0, 1);
                if ((away - (along * share)).Length <= HalfWidthPixels)
                {
                    map[column, row] = number;
                }
            }
        }
    }

    private static (int First, int Last) Range(double a, double b, int count) =>
        (
            Math.Max(0, (int)Math.Floor(Math.Min(a, b) - HalfWidthPixels)),
            Math.Min(count - 1, (int)Math.Ceiling(Math.Max(a, b) + HalfWidthPixels))
        );
}
