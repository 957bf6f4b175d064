using Harvester.Geometry.Maps;

namespace Harvester.Exports.Formats.OpenLaneV2;

/// <summary>
/// The numbers that boundaries and markings of a label have (<see cref="Harvester.Geometry.Lanes.LaneLine.Index"/>), for the edges of the
/// lanes ahead of the ego up to the next junction: measured paint may lie metres beside the edge that it marks.
/// </summary>
internal static class EdgeNumbers
{
    /// <summary>The numbers of the left and the right edge of the lanes of the ego's road.</summary>
    /// <param name="ego">The ego's lane; null if it is not known.</param>
    public static Dictionary<MapLane, (int Left, int Right)> Of(MapLane? ego)
    {
        var numbers = new Dictionary<MapLane, (int Left, int Right)>();
        for (MapLane? lane = ego; lane is { Junction: null } && !numbers.ContainsKey(lane); lane = Next(lane))
        {
            MapLane leftmost = Leftmost(lane);
            for (MapLane? own = leftmost; own is not null; own = own.RightNeighbour)
            {
                numbers.TryAdd(own, (own.Index, own.Index + 1));
            }

            // Without a median between, the line in the middle is number 0, and -1 is left out.
            for (MapLane? other = leftmost.Oncoming; other is not null; other = other.RightNeighbour)
            {
                numbers.TryAdd(other, (other.Index == 0 ? 0 : -(other.Index + 1), -(other.Index + 2)));
            }
        }

        return numbers;
    }

    private static MapLane? Next(MapLane lane) => lane.Successors.FirstOrDefault(next => next.Junction is null);

    private static MapLane Leftmost(MapLane lane)
    {
        while (lane.LeftNeighbour is { } left)
        {
            lane = left;
        }

        return lane;
    }
}
