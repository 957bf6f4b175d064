using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>Why lanes of a map end or begin where no other lane is, from the road data.</summary>
internal sealed class LaneEnds(LaneNetwork map)
{
    /// <summary>Sharper bends between two roads turn back, radians: 115 degrees.</summary>
    private const double MaxBend = 2.0;

    /// <summary>The same in a junction, radians: 137 degrees.</summary>
    private const double MaxTurn = 2.4;

    private readonly Dictionary<int, RoadSegment> _roads = map.Segments.ToDictionary(road => road.Link);

    /// <summary>The cause.</summary>
    /// <param name="lane">A lane of a road.</param>
    /// <param name="atEnd">Whether it is asked for the lane's end, otherwise its beginning.</param>
    public LaneEndCause Of(MapLane lane, bool atEnd)
    {
        int node = NodeOf(lane, atEnd);
        MapJunction? junction = map.Junctions.FirstOrDefault(junction => junction.Nodes.Contains(node));
        int[] nodes = junction is null ? [node] : [.. junction.Nodes];
        RoadSegment[] others =
        [
            .. nodes
                .SelectMany(each => map.Network.LinksOf(each))
                .Distinct()
                .Where(link => link != lane.Link && _roads.ContainsKey(link))
                .Select(link => _roads[link]),
        ];
        MapLane[] open =
        [
            .. others.SelectMany(road => road.Forward.Concat(road.Backward)).Where(other => nodes.Contains(NodeOf(other, !atEnd))),
        ];
        double[] turns = [.. open.Select(other => Math.Abs(atEnd ? Turn(lane, other) : Turn(other, lane)))];
        return others.Length == 0 ? LaneEndCause.RoadEnds
            : open.Length == 0 ? LaneEndCause.OneWayRoads
            : turns.All(turn => turn >= (junction is null ? MaxBend : MaxTurn)) ? LaneEndCause.SharpTurn
            : !open.Where((_, i) => turns[i] < MaxTurn).Any(other => atEnd ? IsAhead(lane, other) : IsAhead(other, lane))
                ? LaneEndCause.RoadsBehind
            : !open.Any(other => atEnd ? AreLinked(lane, other, nodes) : AreLinked(other, lane, nodes)) ? LaneEndCause.NotLinked
            : LaneEndCause.None;
    }

    /// <summary>
    /// Whether one lane ahead of another is reached from it along links within the junction in their direction: those of which nothing is a
    /// road of the map.
    /// </summary>
    private bool AreLinked(MapLane from, MapLane to, int[] nodes)
    {
        if (!IsAhead(from, to) || Math.Abs(Turn(from, to)) >= MaxTurn)
        {
            return false;
        }

        var ways = map
            .Network.Links.Where((link, number) => RoadContinuations.IsDrivable(map.Network, link) && !_roads.ContainsKey(number))
            .SelectMany(link =>
                new[] { (link.From, link.To, Lanes: link.LanesForward), (From: link.To, To: link.From, Lanes: link.LanesBackward) }
            )
            .Where(way => way.Lanes > 0 && nodes.Contains(way.From) && nodes.Contains(way.To))
            .ToLookup(way => way.From, way => way.To);
        HashSet<int> reached = [NodeOf(from, atEnd: true)];
        for (int before = 0; before < reached.Count; )
        {
            before = reached.Count;
            reached.UnionWith([.. reached.SelectMany(node => ways[node])]);
        }

        return reached.Contains(NodeOf(to, atEnd: false));
    }

    private int NodeOf(MapLane lane, bool atEnd) =>
        lane.IsForward == atEnd ? map.Network.Links[lane.Link!.Value].To : map.Network.Links[lane.Link!.Value].From;

    private static double Turn(MapLane from, MapLane to) =>
        Math.Atan2(from.EndDirection.Cross(to.StartDirection), from.EndDirection.Dot(to.StartDirection));

    private static bool IsAhead(MapLane from, MapLane to)
    {
        Vector3D apart = to.Centre[0] - from.Centre[^1];
        var chord = new Vector2D(apart.X, apart.Y);
        return chord.Dot(from.EndDirection) > 0 && chord.Dot(to.StartDirection) > 0;
    }
}
