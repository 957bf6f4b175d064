using System;
using System.Collections.Generic;

namespace Harvester.Geometry.Boxes;

/// <summary>Convex polygons of the image plane as lists of corners in order, without a repeated last corner.</summary>
public static class ConvexPolygon
{
    /// <summary>
    /// The convex hull of points, counter-clockwise in an x-right, y-up plane (clockwise on the screen): Andrew's monotone chain.
    /// Fewer than three distinct or all collinear points give a polygon without area.
    /// </summary>
    public static IReadOnlyList<Vector2D> Hull(IEnumerable<Vector2D> points)
    {
        var sorted = new List<Vector2D>(Guard.NotNull(points, nameof(points)));
        sorted.Sort(static (a, b) => a.X != b.X ? a.X.CompareTo(b.X) : a.Y.CompareTo(b.Y));
        if (sorted.Count == 0)
        {
            return sorted;
        }

        if (sorted[0] == sorted[sorted.Count - 1])
        {
            return [sorted[0]];
        }

        var hull = new List<Vector2D>(sorted.Count + 1);
        AddChain(hull, sorted, 0);
        sorted.Reverse();
        int lowerEnd = hull.Count - 1;
        hull.RemoveAt(lowerEnd);
        AddChain(hull, sorted, lowerEnd);
        hull.RemoveAt(hull.Count - 1);
        return hull;
    }

    /// <summary>Area in square units of the plane; 0 for fewer than three corners.</summary>
    public static double Area(IReadOnlyList<Vector2D> polygon)
    {
        Guard.NotNull(polygon, nameof(polygon));
        double doubled = 0;
        for (int i = 0; i < polygon.Count; i++)
        {
            // Relative to the first corner, so that far-off polygons do not lose digits.
            doubled += (polygon[i] - polygon[0]).Cross(polygon[(i + 1) % polygon.Count] - polygon[0]);
        }

        return Math.Abs(doubled) / 2;
    }

    /// <summary>
    /// The part of a polygon within a box, sides included: Sutherland and Hodgman's clipping at the four sides. Where a polygon that is
    /// not convex falls into parts, they stay joined along the box's sides, which changes neither area nor bounds.
    /// </summary>
    /// <returns>The clipped polygon; empty when nothing is left.</returns>
    public static IReadOnlyList<Vector2D> Clip(IReadOnlyList<Vector2D> polygon, Box2D box)
    {
        IReadOnlyList<Vector2D> clipped = Guard.NotNull(polygon, nameof(polygon));
        if (IsWithin(polygon, box))
        {
            return polygon;
        }

        clipped = ClipSide(clipped, p => p.X - box.XMin);
        clipped = ClipSide(clipped, p => box.XMax - p.X);
        clipped = ClipSide(clipped, p => p.Y - box.YMin);
        return ClipSide(clipped, p => box.YMax - p.Y);
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
    /// <returns>Null for no points.</returns>
    public static Box2D? Bounds(IReadOnlyList<Vector2D> points)
    {
        Guard.NotNull(points, nameof(points));
        Box2D? bounds = null;
        for (int i = 0; i < points.Count; i++)
        {
            var own = new Box2D(points[i].X, points[i].Y, points[i].X, points[i].Y);
            bounds = bounds?.Union(own) ?? own;
        }

        return bounds;
    }

    private static bool IsWithin(IReadOnlyList<Vector2D> polygon, Box2D box)
    {
        for (int i = 0; i < polygon.Count; i++)
        {
            Vector2D corner = polygon[i];
            if (!(corner.X >= box.XMin && corner.X <= box.XMax && corner.Y >= box.YMin && corner.Y <= box.YMax))
            {
                return false;
            }
        }

        return true;
    }

    private static void AddChain(List<Vector2D> hull, List<Vector2D> sorted, int start)
    {
        foreach (Vector2D point in sorted)
        {
            while (hull.Count >= start + 2 && (hull[hull.Count - 1] - hull[hull.Count - 2]).Cross(point - hull[hull.Count - 1]) <= 0)
            {
                hull.RemoveAt(hull.Count - 1);
            }

            hull.Add(point);
        }
    }

    private static List<Vector2D> ClipSide(IReadOnlyList<Vector2D> polygon, Func<Vector2D, double> inside)
    {
        var kept = new List<Vector2D>(polygon.Count + 1);
        for (int i = 0; i < polygon.Count; i++)
        {
            Vector2D current = polygon[i];
            Vector2D next = polygon[(i + 1) % polygon.Count];
            double a = inside(current);
            double b = inside(next);
            if (a >= 0)
            {
                kept.Add(current);
            }

            if ((a > 0 && b < 0) || (a < 0 && b > 0))
            {
                kept.Add(current + ((next - current) * (a / (a - b))));
            }
        }

        return kept;
    }
}
