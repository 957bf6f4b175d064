namespace Harvester.Geometry.Boxes;

/// <summary>
/// A reusable list of points of the plane, with the algorithms of <see cref="ConvexPolygon"/>; it allocates only to grow. The points are
/// the corners of a polygon in order; the first corner is not repeated at the end.
/// </summary>
internal sealed class PointBuffer
{
    /// <summary>Maximum number of points for insertion sort, the fastest for few points; a cuboid has eight.</summary>
    private const int MaxInserted = 32;

    private static readonly Comparison<Vector2D> LeftToRight = static (a, b) => a.X != b.X ? a.X.CompareTo(b.X) : a.Y.CompareTo(b.Y);
#if !NET
    private static readonly Comparer<Vector2D> LeftToRightComparer = Comparer<Vector2D>.Create(LeftToRight);
#endif

    private Vector2D[] _points = new Vector2D[MaxInserted];

    public int Count { get; private set; }

    public Vector2D this[int index] => _points[index];

    public void Clear() => Count = 0;

    public void Add(Vector2D point)
    {
        if (Count == _points.Length)
        {
            Array.Resize(ref _points, 2 * Count);
        }

        _points[Count++] = point;
    }

    public void AddRange(IEnumerable<Vector2D> points)
    {
        foreach (Vector2D point in points)
        {
            Add(point);
        }
    }

    public Vector2D[] ToArray()
    {
        var points = new Vector2D[Count];
        Array.Copy(_points, points, Count);
        return points;
    }

    /// <summary>Sets this to the convex hull of points (Andrew's monotone chain). Sorts the given points.</summary>
    public void SetHullOf(PointBuffer points)
    {
        Clear();
        points.Sort();
        if (points.Count == 0)
        {
            return;
        }

        Vector2D first = points[0];
        if (first == points[points.Count - 1])
        {
            Add(first);
            return;
        }

        // The lower chain from left to right, then the upper one back; each chain's last point begins the next and is dropped.
        for (int i = 0; i < points.Count; i++)
        {
            AddToChain(points[i], 0);
        }

        int lowerEnd = --Count;
        for (int i = points.Count - 1; i >= 0; i--)
        {
            AddToChain(points[i], lowerEnd);
        }

        Count--;
    }

    /// <summary>The area in square units.</summary>
    public double Area()
    {
        double doubled = 0;
        for (int i = 0; i < Count; i++)
        {
            // Relative to the first corner, so that polygons far from the origin keep their precision.
            // Shoelace formula: twice the area is the sum of the cross products of neighbouring corners.
            doubled += (_points[i] - _points[0]).Cross(_points[(i + 1) % Count] - _points[0]);
        }

        return Math.Abs(doubled) / 2;
    }

    /// <summary>The smallest box around the points; null for no points.</summary>
    public Box2D? Bounds()
    {
        if (Count == 0)
        {
            return null;
        }

        var bounds = new Box2D(_points[0].X, _points[0].Y, _points[0].X, _points[0].Y);
        for (int i = 1; i < Count; i++)
        {
            bounds = bounds.Union(new Box2D(_points[i].X, _points[i].Y, _points[i].X, _points[i].Y));
        }

        return bounds;
    }

    /// <summary>Whether no point lies outside a box, sides included.</summary>
    public bool IsWithin(Box2D box)
    {
        for (int i = 0; i < Count; i++)
        {
            Vector2D corner = _points[i];
            if (!(corner.X >= box.XMin && corner.X <= box.XMax && corner.Y >= box.YMin && corner.Y <= box.YMax))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Sets this to the part of a polygon within a box: Sutherland and Hodgman's clipping at the four sides.</summary>
    /// <param name="polygon">The polygon; not changed.</param>
    /// <param name="box">The box.</param>
    /// <param name="spare">A buffer for intermediate results.</param>
    public void SetClipped(PointBuffer polygon, Box2D box, PointBuffer spare)
    {
        spare.SetInside(polygon, 1, 0, -box.XMin);
        SetInside(spare, -1, 0, box.XMax);
        spare.SetInside(this, 0, 1, -box.YMin);
        SetInside(spare, 0, -1, box.YMax);
    }

    /// <summary>Sets this to the part of a polygon where x · alongX + y · alongY + offset is 0 or more; one factor is 0.</summary>
    private void SetInside(PointBuffer polygon, double alongX, double alongY, double offset)
    {
        Clear();
        for (int i = 0; i < polygon.Count; i++)
        {
            Vector2D current = polygon[i];
            Vector2D next = polygon[(i + 1) % polygon.Count];
            double a = (current.X * alongX) + (current.Y * alongY) + offset;
            double b = (next.X * alongX) + (next.Y * alongY) + offset;
            if (a >= 0)
            {
                Add(current);
            }

            // The distance changes linearly from a to b along the side and is 0 at the fraction a / (a - b).
            if ((a > 0 && b < 0) || (a < 0 && b > 0))
            {
                Add(current + ((next - current) * (a / (a - b))));
            }
        }
    }

    private void Sort()
    {
        if (Count > MaxInserted)
        {
#if NET
            _points.AsSpan(0, Count).Sort(LeftToRight);
#else
            Array.Sort(_points, 0, Count, LeftToRightComparer);
#endif
            return;
        }

        for (int i = 1; i < Count; i++)
        {
            Vector2D point = _points[i];
            int place = i;
            for (; place > 0 && IsBefore(point, _points[place - 1]); place--)
            {
                _points[place] = _points[place - 1];
            }

            _points[place] = point;
        }
    }

    private static bool IsBefore(Vector2D point, Vector2D other) => point.X < other.X || (point.X == other.X && point.Y < other.Y);

    private void AddToChain(Vector2D point, int start)
    {
        // The chain turns left everywhere: a last corner where it turns right or goes straight on is no corner of the hull.
        while (Count >= start + 2 && (_points[Count - 1] - _points[Count - 2]).Cross(point - _points[Count - 1]) <= 0)
        {
            Count--;
        }

        Add(point);
    }
}
