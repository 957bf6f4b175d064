using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>
/// Edges of lanes that turn in less than half their width. The inner edge would run back in a loop there; it has a corner instead, where
/// the edge before the turn meets the one behind it.
/// </summary>
internal static class UnfoldedLine
{
    /// <summary>Whether an edge of a lane runs against its middle anywhere.</summary>
    /// <param name="edge">Points of the edge.</param>
    /// <param name="middle">As many points of the middle.</param>
    public static bool IsFolded(IReadOnlyList<Vector3D> edge, IReadOnlyList<Vector3D> middle)
    {
        for (int i = 1; i < edge.Count; i++)
        {
            if (RunsBack(edge[i - 1], edge[i], middle[i] - middle[i - 1]))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>
    /// The edge without its loops. As in isotonic regression by pooling adjacent violators, points of which one lies behind the one before
    /// it become one, in the middle between the first and the last of them; both ends stay.
    /// </summary>
    /// <param name="edge">Points of the edge, from an end that does not lie behind the start.</param>
    /// <param name="axis">As many points of the line of its road, beside which the edge should run.</param>
    /// <returns>The points, at least both ends.</returns>
    public static IReadOnlyList<Vector3D> Of(IReadOnlyList<Vector3D> edge, IReadOnlyList<Vector3D> axis)
    {
        var pools = new List<(int First, int Last)>();
        for (int i = 0; i < edge.Count; i++)
        {
            (int First, int Last) pool = (i, i);
            while (pools.Count > 0 && RunsBack(PlaceOf(edge, pools[^1]), PlaceOf(edge, pool), axis[pool.First] - axis[pools[^1].Last]))
            {
                pool = (pools[^1].First, pool.Last);
                pools.RemoveAt(pools.Count - 1);
            }

            pools.Add(pool);
        }

        return pools.Count == 1 ? [edge[0], edge[^1]] : [.. pools.Select(pool => PlaceOf(edge, pool))];
    }

    private static Vector3D PlaceOf(IReadOnlyList<Vector3D> edge, (int First, int Last) pool)
    {
        if (pool.First == 0)
        {
            return edge[0];
        }

        return pool.Last == edge.Count - 1 ? edge[^1] : (edge[pool.First] + edge[pool.Last]) * 0.5;
    }

    /// <summary>Whether the way from one point to the next, on the ground, is against a direction.</summary>
    private static bool RunsBack(Vector3D from, Vector3D to, Vector3D direction) =>
        ((to.X - from.X) * direction.X) + ((to.Y - from.Y) * direction.Y) < 0;
}
