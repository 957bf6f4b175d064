using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>The points of the middles and edges of lanes.</summary>
internal static class LanePoints
{
    /// <summary>The greatest distance of the points of lanes, metres.</summary>
    private const double MaxStep = 4;

    /// <summary>How far the line between two points may leave the curve, metres.</summary>
    private const double MaxSagitta = 0.005;

    /// <summary>The greatest number of pieces of a lane: links of more than 8 km have longer ones.</summary>
    private const int MaxSteps = 2000;

    /// <summary>Pieces in which the bend of a curve is summed.</summary>
    private const int BendPieces = 8;

    /// <summary>The points beside a curve, at most 4 m apart and closer in bends.</summary>
    /// <param name="line">The curve.</param>
    /// <param name="offset">Metres to the right of the curve at a parameter from 0 to 1.</param>
    public static Vector3D[] Beside(HermiteCurve line, Func<double, double> offset)
    {
        int steps = StepsOf(line);
        var points = new Vector3D[steps + 1];
        for (int i = 0; i <= steps; i++)
        {
            double t = (double)i / steps;
            points[i] = line.PointBeside(t, offset(t));
        }

        return points;
    }

    /// <summary>
    /// Of a curve of length l that bends by b, a piece of l / n bends by b / n and leaves its chord by s = l b / (8 n²), so that
    /// n = √(l b / (8 s)).
    /// </summary>
    private static int StepsOf(HermiteCurve line)
    {
        double length = line.Length;
        double bend = 0;
        Vector2D before = line.VelocityAt(0);
        for (int i = 1; i <= BendPieces; i++)
        {
            Vector2D now = line.VelocityAt(i / (double)BendPieces);
            bend += Math.Abs(Math.Atan2(before.Cross(now), before.Dot(now)));
            before = now;
        }

        double steps = Math.Max(length / MaxStep, Math.Sqrt(length * bend / (8 * MaxSagitta)));
        return (int)Math.Max(1, Math.Min(MaxSteps, Math.Ceiling(steps)));
    }
}
