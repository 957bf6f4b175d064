using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;

namespace Harvester.Exports.Maps;

/// <summary>
/// The middle of a lane as arcs that continue each other without a bend: pairs of arcs (biarcs) through points of the middle with its
/// directions there.
/// </summary>
internal static class LaneArcs
{
    /// <summary>How far points of the middle may lie beside the arcs, metres.</summary>
    private const double Tolerance = 0.01;

    /// <summary>Where the ends lie this exactly behind each other, tangents would be endless.</summary>
    private const double Backwards = 1e-9;

    /// <summary>
    /// Arcs are at most this much longer than the line through the points, by more than that of a half circle and its chord. Where the
    /// middle turns back on itself, they would make a loop; there it is a line.
    /// </summary>
    private const double MaxDetour = 1.6;

    /// <summary>Shorter arcs are left out, metres.</summary>
    private const double MinLength = 1e-4;

    /// <summary>The arcs of a lane.</summary>
    /// <param name="lane">The lane.</param>
    /// <param name="line">The curve whose parameter its points divide evenly: its own, or its road's in its direction.</param>
    public static IReadOnlyList<LaneArc> Of(MapLane lane, HermiteCurve line)
    {
        int last = lane.Centre.Count - 1;
        Vector2D[] points = [.. lane.Centre.Select(point => new Vector2D(point.X, point.Y))];
        Vector2D[] directions =
        [
            .. points.Select(
                (_, i) =>
                    Unit(line.VelocityAt((double)i / last))
                    ?? Unit(points[Math.Min(i + 1, last)] - points[Math.Min(i, last - 1)])
                    ?? new Vector2D(1, 0)
            ),
        ];
        var arcs = new List<LaneArc>();
        var spans = new Stack<(int First, int Last)>([(0, last)]);
        while (spans.TryPop(out (int First, int Last) span))
        {
            (Vector2D from, Vector2D to) = (points[span.First], points[span.Last]);
            LaneArc[] pair = Pair(from, directions[span.First], to, directions[span.Last]);
            int middle = (span.First + span.Last) / 2;
            bool isPiece = middle == span.First;
            bool isDirect = pair.Sum(arc => arc.Length) <= MaxDetour * LengthOf(points, span.First, span.Last);
            if (isPiece || (isDirect && Fits(pair, points, span.First, span.Last)))
            {
                bool isLine = !isDirect || Array.TrueForAll(pair, arc => arc.IsStraight);
                arcs.AddRange((isLine ? [Arc(from, to - from, to)] : pair).Where(arc => arc.Length >= MinLength));
            }
            else
            {
                spans.Push((middle, span.Last));
                spans.Push((span.First, middle));
            }
        }

        return arcs;
    }

    private static double LengthOf(Vector2D[] points, int first, int last) =>
        Enumerable.Range(first, last - first).Sum(i => (points[i + 1] - points[i]).Length);

    private static Vector2D? Unit(Vector2D vector) => vector.Length > 0 ? vector * (1 / vector.Length) : null;

    /// <summary>
    /// Two arcs from a point with a direction to another: with tangents of equal length d to where they meet, half way between
    /// from + d·before and to - d·after.
    /// </summary>
    private static LaneArc[] Pair(Vector2D from, Vector2D before, Vector2D to, Vector2D after)
    {
        Vector2D apart = to - from;
        double along = apart.Dot(before + after);
        double bend = 2 * (1 - before.Dot(after));
        double root = Math.Sqrt((along * along) + (bend * apart.Dot(apart)));

        // The solution of bend d² + 2 along d = apart², in the form that holds for bend = 0.
        double tangent = along + root > apart.Length * Backwards ? apart.Dot(apart) / (along + root) : apart.Length / 2;
        Vector2D joint = (from + to + ((before - after) * tangent)) * 0.5;
        LaneArc first = Arc(from, before, joint);
        (double _, double _, double heading) = first.At(first.Length);
        return [first, Arc(joint, new Vector2D(Math.Cos(heading), Math.Sin(heading)), to)];
    }

    private static LaneArc Arc(Vector2D from, Vector2D direction, Vector2D to)
    {
        Vector2D chord = to - from;
        double length = chord.Length;
        double half = Math.Atan2(direction.Cross(chord), direction.Dot(chord));
        double sine = Math.Sin(half);
        double heading = Math.Atan2(direction.Y, direction.X);
        return length > 0 && Math.Abs(sine) * 2 / length >= 1e-6
            ? new LaneArc(from.X, from.Y, heading, 2 * sine / length, length * half / sine)
            : new LaneArc(from.X, from.Y, heading, 0, length);
    }

    private static bool Fits(LaneArc[] pair, Vector2D[] points, int first, int last)
    {
        for (int i = first + 1; i < last; i++)
        {
            if (pair.Min(arc => DistanceFrom(arc, points[i])) > Tolerance)
            {
                return false;
            }
        }

        return true;
    }

    private static double DistanceFrom(LaneArc arc, Vector2D point)
    {
        Vector2D direction = new(Math.Cos(arc.Heading), Math.Sin(arc.Heading));
        Vector2D to = point - new Vector2D(arc.X, arc.Y);
        double station;
        if (arc.IsStraight)
        {
            station = direction.Dot(to);
        }
        else
        {
            // The angle at the centre from the start to the point, in the arc's direction of turning.
            double side = Math.Sign(arc.Curvature);
            var centre = new Vector2D(-direction.Y, direction.X) * (1 / arc.Curvature);
            Vector2D start = centre * -1;
            Vector2D end = to - centre;
            station = side * Math.Atan2(start.Cross(end), start.Dot(end)) / Math.Abs(arc.Curvature);
        }

        (double x, double y, double _) = arc.At(Math.Clamp(station, 0, arc.Length));
        return (point - new Vector2D(x, y)).Length;
    }
}
