using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>Edges of lanes that turn in less than half their width: the inner edge runs back, and crosses itself.</summary>
internal static class FoldedLine
{
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

    /// <summary>The line without the loop between the first two of its pieces that cross; the line itself if none do.</summary>
    public static IReadOnlyList<Vector3D> Trimmed(IReadOnlyList<Vector3D> line)
    {
        for (int i = 0; i < line.Count - 1; i++)
        {
            for (int j = line.Count - 2; j > i + 1; j--)
            {
                if (Crossing(line[i], line[i + 1], line[j], line[j + 1]) is { } point)
                {
                    return [.. line.Take(i + 1), point, .. line.Skip(j + 1)];
                }
            }
        }

        return line;
    }

    private static Vector3D? Crossing(Vector3D from, Vector3D to, Vector3D otherFrom, Vector3D otherTo)
    {
        (Vector2D line, Vector2D other) = (Ground(to - from), Ground(otherTo - otherFrom));
        Vector2D between = Ground(otherFrom - from);
        double area = line.Cross(other);
        double along = between.Cross(other) / area;
        double alongOther = between.Cross(line) / area;
        return area != 0 && along is > 0 and < 1 && alongOther is > 0 and < 1 ? from + ((to - from) * along) : null;
    }

    private static Vector2D Ground(Vector3D vector) => new(vector.X, vector.Y);
}
