namespace Harvester.Simulation.Tests.Events;

/// <summary>Distances between polygons by brute force: all pairs of edges, and points within.</summary>
internal static class Polygons
{
    /// <summary>Distance of two polygons, metres; 0 if they overlap.</summary>
    public static double Distance((double X, double Y)[] a, (double X, double Y)[] b)
    {
        if (Contains(a, b[0]) || Contains(b, a[0]))
        {
            return 0;
        }

        double least = double.PositiveInfinity;
        for (int i = 0; i < a.Length; i++)
        {
            for (int j = 0; j < b.Length; j++)
            {
                least = Math.Min(least, Distance(a[i], a[(i + 1) % a.Length], b[j], b[(j + 1) % b.Length]));
            }
        }

        return least;
    }

    /// <summary>Whether a point lies within a polygon: a ray from it to the east meets an odd number of edges.</summary>
    private static bool Contains((double X, double Y)[] polygon, (double X, double Y) point)
    {
        bool isInside = false;
        for (int i = 0; i < polygon.Length; i++)
        {
            (double X, double Y) p = polygon[i];
            (double X, double Y) q = polygon[(i + 1) % polygon.Length];
            if (p.Y > point.Y != q.Y > point.Y && point.X < p.X + ((point.Y - p.Y) / (q.Y - p.Y) * (q.X - p.X)))
            {
                isInside = !isInside;
            }
        }

        return isInside;
    }

    private static double Distance((double X, double Y) a, (double X, double Y) b, (double X, double Y) c, (double X, double Y) d) =>
        Side(a, b, c) * Side(a, b, d) < 0 && Side(c, d, a) * Side(c, d, b) < 0
            ? 0
            : Math.Min(Math.Min(FromEdge(a, b, c), FromEdge(a, b, d)), Math.Min(FromEdge(c, d, a), FromEdge(c, d, b)));

    private static double Side((double X, double Y) a, (double X, double Y) b, (double X, double Y) p) =>
        Math.Sign(((b.X - a.X) * (p.Y - a.Y)) - ((b.Y - a.Y) * (p.X - a.X)));

    private static double FromEdge((double X, double Y) a, (double X, double Y) b, (double X, double Y) p)
    {
        (double x, double y) = (b.X - a.X, b.Y - a.Y);
        double along = Math.Clamp((((p.X - a.X) * x) + ((p.Y - a.Y) * y)) / ((x * x) + (y * y)), 0, 1);
        return Math.Sqrt(Math.Pow(a.X + (along * x) - p.X, 2) + Math.Pow(a.Y + (along * y) - p.Y, 2));
    }
}
