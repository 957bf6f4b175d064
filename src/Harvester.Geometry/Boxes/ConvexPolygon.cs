namespace Harvester.Geometry.Boxes;

/// <summary>Convex polygons of the image plane as lists of corners in order; the first corner is not repeated at the end.</summary>
public static class ConvexPolygon
{
    /// <summary>
    /// The convex hull of points, counter-clockwise in an x-right, y-up plane (clockwise on the screen): Andrew's monotone chain. Fewer
    /// than three distinct points, or collinear points, give a polygon without area.
    /// </summary>
    public static IReadOnlyList<Vector2D> Hull(IEnumerable<Vector2D> points)
    {
        var all = new PointBuffer();
        all.AddRange(Guard.NotNull(points, nameof(points)));
        var hull = new PointBuffer();
        hull.SetHullOf(all);
        return hull.ToArray();
    }

    /// <summary>Area in square units of the plane; 0 for fewer than three corners.</summary>
    public static double Area(IReadOnlyList<Vector2D> polygon) => Buffered(polygon, nameof(polygon)).Area();

    /// <summary>
    /// The part of a polygon within a box, sides included: Sutherland and Hodgman's clipping at the four sides. If a polygon that is not
    /// convex is divided, its parts stay joined along the box's sides, which changes neither area nor bounds.
    /// </summary>
    /// <returns>The clipped polygon; empty if nothing remains.</returns>
    public static IReadOnlyList<Vector2D> Clip(IReadOnlyList<Vector2D> polygon, Box2D box)
    {
        PointBuffer whole = Buffered(polygon, nameof(polygon));
        if (whole.IsWithin(box))
        {
            return polygon;
        }

        var clipped = new PointBuffer();
        clipped.SetClipped(whole, box, new PointBuffer());
        return clipped.ToArray();
    }

    /// <summary>
    /// Whether a point lies within a convex polygon of either winding, sides included. A polygon without area contains nothing.
    /// </summary>
    public static bool Contains(IReadOnlyList<Vector2D> polygon, Vector2D point)
    {
        Guard.NotNull(polygon, nameof(polygon));
        bool left = false;
        bool right = false;
        for (int i = 0; i < polygon.Count; i++)
        {
            double side = (polygon[(i + 1) % polygon.Count] - polygon[i]).Cross(point - polygon[i]);
            left |= side > 0;
            right |= side < 0;
        }

        return left != right;
    }

    /// <summary>The smallest box around points.</summary>
    /// <returns>Null if there are no points.</returns>
    public static Box2D? Bounds(IReadOnlyList<Vector2D> points) => Buffered(points, nameof(points)).Bounds();

    private static PointBuffer Buffered(IReadOnlyList<Vector2D> polygon, string name)
    {
        var buffer = new PointBuffer();
        buffer.AddRange(Guard.NotNull(polygon, name));
        return buffer;
    }
}
