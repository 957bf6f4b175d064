using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>Straight pieces joined by arcs, cut into points for the nodes of a road.</summary>
internal static class RoundedWay
{
    private const double MaxStep = 14;
    private const double MaxTurnOfStep = 0.2;

    /// <summary>Points along the path, including its ends.</summary>
    /// <param name="corners">Ends and corners of the straight pieces, metres; heights are ignored.</param>
    /// <param name="radius">Radius of the arcs; smaller if the pieces are too short for it.</param>
    public static List<Vector3D> Sample(IReadOnlyList<Vector3D> corners, double radius)
    {
        List<Vector3D> points = [corners[0]];
        for (int i = 1; i < corners.Count - 1; i++)
        {
            AddCorner(points, corners[i - 1], corners[i], corners[i + 1], radius);
        }

        AddStraight(points, corners[^1]);
        return points;
    }

    private static void AddCorner(List<Vector3D> points, Vector3D before, Vector3D corner, Vector3D after, double radius)
    {
        Vector3D into = (corner - before).Normalized();
        Vector3D outOf = (after - corner).Normalized();
        double turn = Horizontal.Turn(into, outOf);
        double room = 0.48 * Math.Min((corner - before).Length, (after - corner).Length);

        // A circle of radius r touches both sides at r tan(turn / 2) from the corner; if there is not so much room, its radius is smaller.
        double cut = Math.Min(radius * Math.Tan(Math.Abs(turn) / 2), room);
        double actualRadius = cut / Math.Tan(Math.Abs(turn) / 2);
        Vector3D start = corner - (into * cut);
        AddStraight(points, start);
        Vector3D toCentre = Horizontal.RightOf(into) * (turn > 0 ? -actualRadius : actualRadius);
        Vector3D centre = start + toCentre;

        // Enough pieces that none turns or reaches farther than allowed.
        int steps = Math.Max(1, (int)Math.Ceiling(Math.Max(Math.Abs(turn) / MaxTurnOfStep, actualRadius * Math.Abs(turn) / MaxStep)));
        for (int i = 1; i <= steps; i++)
        {
            (double sin, double cos) = Math.SinCos(turn * i / steps);
            Vector3D arm = -toCentre;
            points.Add(centre + new Vector3D((arm.X * cos) - (arm.Y * sin), (arm.X * sin) + (arm.Y * cos), 0));
        }
    }

    private static void AddStraight(List<Vector3D> points, Vector3D end)
    {
        Vector3D start = points[^1];
        double length = (end - start).Length;
        int steps = (int)Math.Ceiling(length / MaxStep);
        const double nothing = 0.5;
        for (int i = 1; i <= steps && length > nothing; i++)
        {
            points.Add(start + ((end - start) * ((double)i / steps)));
        }
    }
}
