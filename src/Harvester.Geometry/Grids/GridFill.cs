namespace Harvester.Geometry.Grids;

/// <summary>The cells of a grid whose middles a triangle covers, seen from above.</summary>
internal static class GridFill
{
    /// <summary>A triangle of a smaller area, in cells, is seen from its edge.</summary>
    private const double MinArea = 1e-9;

    /// <summary>Visits the cells row by row.</summary>
    /// <param name="grid">The grid.</param>
    /// <param name="a">First corner, metres, world.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    /// <param name="visit">Takes the number of a cell, row by row, and the height of the triangle at its middle, metres, world.</param>
    public static void Visit(EgoGrid grid, Vector3D a, Vector3D b, Vector3D c, Action<int, double> visit)
    {
        (Vector2D p, Vector2D q, Vector2D r) = (grid.PlaceOf(a), grid.PlaceOf(b), grid.PlaceOf(c));
        int cells = grid.Cells;
        double area = (q - p).Cross(r - p);
        if (Math.Abs(area) < MinArea)
        {
            return;
        }

        // The height is linear: z = z0 + zu u + zv v, by Cramer's rule from the differences to the first corner.
        (Vector2D toQ, Vector2D toR) = (q - p, r - p);
        double perColumn = (((b.Z - a.Z) * toR.Y) - ((c.Z - a.Z) * toQ.Y)) / area;
        double perRow = (((c.Z - a.Z) * toQ.X) - ((b.Z - a.Z) * toR.X)) / area;
        int first = Math.Max(0, (int)Math.Ceiling(Math.Max(-1, Math.Min(p.Y, Math.Min(q.Y, r.Y)) - 0.5)));
        int last = Math.Min(cells - 1, (int)Math.Floor(Math.Min(cells, Math.Max(p.Y, Math.Max(q.Y, r.Y)) - 0.5)));
        for (int row = first; row <= last; row++)
        {
            // The line through the middles of the row is in the triangle between its crossings with the edges.
            double middle = row + 0.5;
            (double from, double to) = (double.PositiveInfinity, double.NegativeInfinity);
            Cross(p, q, middle, ref from, ref to);
            Cross(q, r, middle, ref from, ref to);
            Cross(r, p, middle, ref from, ref to);
            int left = Math.Max(0, (int)Math.Ceiling(Math.Min(cells, Math.Max(-1, from - 0.5))));
            int right = Math.Min(cells - 1, (int)Math.Floor(Math.Max(-1, Math.Min(cells, to - 0.5))));
            for (int column = left; column <= right; column++)
            {
                visit((row * cells) + column, a.Z + (perColumn * (column + 0.5 - p.X)) + (perRow * (middle - p.Y)));
            }
        }
    }

    /// <summary>Extends a range by the crossing of an edge with a line of equal rows.</summary>
    private static void Cross(Vector2D start, Vector2D end, double row, ref double from, ref double to)
    {
        if ((start.Y <= row && end.Y >= row) || (end.Y <= row && start.Y >= row))
        {
            double at = start.Y == end.Y ? start.X : start.X + ((end.X - start.X) * (row - start.Y) / (end.Y - start.Y));
            from = Math.Min(from, start.Y == end.Y ? Math.Min(start.X, end.X) : at);
            to = Math.Max(to, start.Y == end.Y ? Math.Max(start.X, end.X) : at);
        }
    }
}
