using Harvester.Geometry;

namespace Harvester.Simulation.Crashes;

/// <summary>Where two bodies touch.</summary>
/// <param name="Point">The middle of the area that both cover, metres, world x and y.</param>
/// <param name="Normal">Unit vector from the first body to the second, across the side that the other has entered least.</param>
/// <param name="Depth">How far they overlap along the normal, metres; greater than 0.</param>
internal readonly record struct BodyContact(Vector2D Point, Vector2D Normal, double Depth)
{
    /// <summary>The contact of two bodies; null if they do not overlap.</summary>
    public static BodyContact? Between(PlanarBody first, PlanarBody second)
    {
        Vector2D offset = second.Position - first.Position;
        double reach = first.Radius + second.Radius;
        if (offset.Dot(offset) >= reach * reach)
        {
            return null;
        }

        // Separating axes: rectangles that overlap do so on the directions of all their sides. The least overlap is across the side that
        // was entered last, as long as bodies move little between two looks.
        double depth = double.PositiveInfinity;
        Vector2D normal = default;
        foreach (Vector2D axis in (ReadOnlySpan<Vector2D>)[first.Forward, first.Left, second.Forward, second.Left])
        {
            double along = offset.Dot(axis);
            double overlap = Reach(first, axis) + Reach(second, axis) - Math.Abs(along);
            if (overlap <= 0)
            {
                return null;
            }

            if (overlap < depth)
            {
                depth = overlap;
                normal = along < 0 ? axis * -1 : axis;
            }
        }

        return new BodyContact(Middle(Common(first.Corners, second.Corners)), normal, depth);
    }

    /// <summary>Half the length of a body's shadow on a direction, metres.</summary>
    private static double Reach(PlanarBody body, Vector2D axis) =>
        (Math.Abs(body.Forward.Dot(axis)) * body.HalfLength) + (Math.Abs(body.Left.Dot(axis)) * body.HalfWidth);

    /// <summary>The area that two convex outlines share: one is cut by each side of the other (Sutherland and Hodgman, 1974).</summary>
    private static List<Vector2D> Common(Vector2D[] outline, Vector2D[] cutter)
    {
        List<Vector2D> left = [.. outline];
        for (int i = 0; i < cutter.Length; i++)
        {
            Vector2D start = cutter[i];
            Vector2D side = cutter[(i + 1) % cutter.Length] - start;
            List<Vector2D> kept = [];
            for (int j = 0; j < left.Count; j++)
            {
                Vector2D from = left[j];
                Vector2D to = left[(j + 1) % left.Count];
                double before = side.Cross(from - start);
                double after = side.Cross(to - start);
                if (before >= 0)
                {
                    kept.Add(from);
                }

                if ((before < 0) != (after < 0))
                {
                    kept.Add(from + ((to - from) * (before / (before - after))));
                }
            }

            left = kept;
        }

        return left;
    }

    private static Vector2D Middle(List<Vector2D> outline)
    {
        // Centroid of a polygon, Σ (p + q) (p × q) / (3 Σ p × q), about its first corner; the mean of its corners if it has no area.
        Vector2D origin = outline[0];
        Vector2D weighted = default;
        Vector2D sum = default;
        double area = 0;
        for (int i = 0; i < outline.Count; i++)
        {
            Vector2D from = outline[i] - origin;
            Vector2D to = outline[(i + 1) % outline.Count] - origin;
            double part = from.Cross(to);
            weighted += (from + to) * part;
            area += part;
            sum += from;
        }

        const double noArea = 1e-12;
        return origin + (area > noArea ? weighted * (1 / (3 * area)) : sum * (1.0 / outline.Count));
    }
}
