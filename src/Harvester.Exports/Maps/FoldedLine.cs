using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>Edges of lanes that turn in less than half their width: the inner edge would run back.</summary>
internal static class FoldedLine
{
    /// <summary>The part of the radius of a turn that is left between its inner edge and the middle.</summary>
    private const double RadiusFraction = 0.8;

    /// <summary>Whether an edge of a lane runs against its middle anywhere.</summary>
    /// <param name="edge">Points of the edge.</param>
    /// <param name="middle">As many points of the middle.</param>
    public static bool IsFolded(IReadOnlyList<Vector3D> edge, IReadOnlyList<Vector3D> middle)
    {
        for (int i = 1; i < edge.Count; i++)
        {
            if (Ground(edge[i] - edge[i - 1]).Dot(Ground(middle[i] - middle[i - 1])) < 0)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The edge, between its ends nearer to the middle where that turns more sharply than the edge can follow.</summary>
    /// <param name="edge">Points of the edge.</param>
    /// <param name="middle">As many points of the middle.</param>
    public static IReadOnlyList<Vector3D> Unfolded(IReadOnlyList<Vector3D> edge, IReadOnlyList<Vector3D> middle)
    {
        Vector3D[] points = [.. edge];

        // Both ends stay where the edges of the lanes before and after it are.
        for (int i = 1; i < points.Length - 1; i++)
        {
            Vector3D aside = edge[i] - middle[i];
            Vector2D before = Ground(middle[i] - middle[i - 1]);
            Vector2D after = Ground(middle[i + 1] - middle[i]);
            double turn = Math.Atan2(before.Cross(after), before.Dot(after));
            bool isInside = turn * before.Cross(Ground(aside)) > 0;
            double radius = (before.Length + after.Length) / 2 / Math.Abs(turn);
            double kept = isInside ? Math.Min(1, RadiusFraction * radius / Ground(aside).Length) : 1;
            points[i] = middle[i] + (aside * kept);
        }

        return points;
    }

    private static Vector2D Ground(Vector3D vector) => new(vector.X, vector.Y);
}
