using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>Leaves out points of a line that lie on it without them (Ramer, Douglas and Peucker).</summary>
internal static class ThinnedLine
{
    /// <summary>The points to keep.</summary>
    /// <param name="points">A line of at least two points.</param>
    /// <param name="tolerance">How far a point that is left out may lie from the rest, metres.</param>
    public static IReadOnlyList<Vector3D> Of(IReadOnlyList<Vector3D> points, double tolerance)
    {
        bool[] isKept = new bool[points.Count];
        (isKept[0], isKept[^1]) = (true, true);
        var spans = new Stack<(int First, int Last)>([(0, points.Count - 1)]);
        while (spans.TryPop(out (int First, int Last) span))
        {
            (int farthest, double distance) = (span.First, tolerance);
            for (int i = span.First + 1; i < span.Last; i++)
            {
                double apart = DistanceFrom(points[span.First], points[span.Last], points[i]);
                if (apart > distance)
                {
                    (farthest, distance) = (i, apart);
                }
            }

            if (farthest > span.First)
            {
                isKept[farthest] = true;
                spans.Push((span.First, farthest));
                spans.Push((farthest, span.Last));
            }
        }

        return [.. points.Where((_, i) => isKept[i])];
    }

    private static double DistanceFrom(Vector3D from, Vector3D to, Vector3D point)
    {
        Vector3D line = to - from;
        double square = line.Dot(line);
        double along = square > 0 ? Math.Clamp((point - from).Dot(line) / square, 0, 1) : 0;
        return (point - from - (line * along)).Length;
    }
}
