using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>
/// A car that follows a way through a junction, from the lane before it to the lane after it: a single-track model with a limited steering
/// angle, steered by pure pursuit. It shares nothing with the curves of the map but their points.
/// </summary>
internal static class FollowingCar
{
    /// <summary>Distance between the axles, metres.</summary>
    private const double Wheelbase = 2.7;

    /// <summary>Half of its width, metres.</summary>
    private const double HalfWidth = 0.95;

    /// <summary>
    /// The least radius of the middle of its rear axle, metres: a turning circle of 10.6 m from kerb to kerb, as small cars have, with the
    /// wheelbase above and a track of 1.5 m.
    /// </summary>
    private const double MinRadius = 3.8;

    /// <summary>How far ahead on the line the point lies to which it steers, metres.</summary>
    private const double LookAhead = 2.5;

    /// <summary>How far it drives between two looks, metres.</summary>
    private const double Step = 0.1;

    /// <summary>How much of the lanes before and after the way it drives, metres.</summary>
    private const double RunUp = 12;

    /// <summary>Distance of the places on the line that it knows, metres.</summary>
    private const double Spacing = 0.1;

    /// <summary>Whether both axles stay between the edges, by half of the car's width, from lane to lane.</summary>
    public static bool StaysOn(MapLane way)
    {
        (Vector2D Place, double HalfWidth)[] line = LineOf(way);
        if (line.Length < 2)
        {
            return true;
        }

        Vector2D along = line[1].Place - line[0].Place;
        (Vector2D rear, double heading) = (line[0].Place, Math.Atan2(along.Y, along.X));
        int ahead = (int)(LookAhead / Spacing);
        int nearest = 0;
        int limit = (int)(3 * line.Length * Spacing / Step);
        for (int step = 0; nearest + ahead < line.Length - 1 && step < limit; step++)
        {
            while (nearest < line.Length - 1 && Apart(line[nearest + 1].Place, rear) <= Apart(line[nearest].Place, rear))
            {
                nearest++;
            }

            var forward = new Vector2D(Math.Cos(heading), Math.Sin(heading));
            if (!IsBetweenEdges(line, nearest, rear) || !IsBetweenEdges(line, nearest, rear + (forward * Wheelbase)))
            {
                return false;
            }

            // Pure pursuit: the circle through the rear axle, along the heading, and the point ahead has the curvature 2 y / d².
            Vector2D target = line[Math.Min(nearest + ahead, line.Length - 1)].Place - rear;
            double curvature = 2 * forward.Cross(target) / Math.Max(target.Dot(target), Spacing);
            curvature = Math.Clamp(curvature, -1 / MinRadius, 1 / MinRadius);
            heading += curvature * Step / 2;
            rear += new Vector2D(Math.Cos(heading), Math.Sin(heading)) * Step;
            heading += curvature * Step / 2;
        }

        return nearest + ahead >= line.Length - 1;
    }

    private static bool IsBetweenEdges((Vector2D Place, double HalfWidth)[] line, int from, Vector2D place)
    {
        int reach = (int)(2 * Wheelbase / Spacing);
        (double apart, double half) = (double.PositiveInfinity, 0);
        for (int i = Math.Max(0, from - reach); i < Math.Min(line.Length, from + reach); i++)
        {
            double distance = Apart(line[i].Place, place);
            (apart, half) = distance < apart ? (distance, line[i].HalfWidth) : (apart, half);
        }

        return apart + HalfWidth <= half;
    }

    private static double Apart(Vector2D a, Vector2D b) => (a - b).Length;

    /// <summary>The middle of the way with the ends of the lanes before and after it, and half of the width there.</summary>
    private static (Vector2D Place, double HalfWidth)[] LineOf(MapLane way)
    {
        (Vector2D Place, double HalfWidth)[] before = Places(way.Predecessors[0]);
        (Vector2D Place, double HalfWidth)[] after = Places(way.Successors[0]);
        int runUp = (int)(RunUp / Spacing);
        return [.. before.TakeLast(runUp), .. Places(way).Skip(1), .. after.Skip(1).Take(runUp)];
    }

    private static (Vector2D Place, double HalfWidth)[] Places(MapLane lane)
    {
        var places = new List<(Vector2D, double)>();
        for (int i = 1; i < lane.Centre.Count; i++)
        {
            (Vector2D a, Vector2D b) = (Ground(lane.Centre[i - 1]), Ground(lane.Centre[i]));
            (double first, double last) = (HalfOf(lane, i - 1), HalfOf(lane, i));
            int pieces = Math.Max(1, (int)Math.Round((b - a).Length / Spacing));
            for (int piece = i == 1 ? 0 : 1; piece <= pieces; piece++)
            {
                double t = (double)piece / pieces;
                places.Add((a + ((b - a) * t), first + ((last - first) * t)));
            }
        }

        return [.. places];
    }

    private static double HalfOf(MapLane lane, int point) => Apart(Ground(lane.Right[point]), Ground(lane.Left[point])) / 2;

    private static Vector2D Ground(Vector3D point) => new(point.X, point.Y);
}
