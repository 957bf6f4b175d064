using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;

namespace Harvester.Driving.Scenarios;

/// <summary>The surroundings of the ego's start: its lane, the track ahead, and the first junction.</summary>
public sealed class StagePlace
{
    /// <summary>As in GTA V, stop lines before lights are nodes of the roads within this distance of the junction, metres.</summary>
    private const double LightRange = 45;

    /// <summary>Lanes within this distance of a place are looked at, metres.</summary>
    private const double Reach = 25;
    private const double SameWay = 0.8;

    private readonly LaneChain _chain;

    private StagePlace(LaneNetwork map, MapLane lane, LaneChain chain) => (Map, Lane, _chain) = (map, lane, chain);

    /// <summary>The lanes.</summary>
    public LaneNetwork Map { get; }

    /// <summary>The ego's lane at the start.</summary>
    public MapLane Lane { get; }

    /// <summary>The line along which the ego drives; 0 is its start.</summary>
    public LaneTrack Track => _chain.Track;

    /// <summary>The first junction with a choice ahead; null if there is none on the track.</summary>
    public StageJunction? Junction { get; private set; }

    /// <summary>The place at which an ego stands.</summary>
    /// <param name="map">The lanes.</param>
    /// <param name="lane">Its lane, outside junctions.</param>
    /// <param name="position">Where it stands, metres, world.</param>
    /// <param name="turn">Where it turns at the first junction.</param>
    internal static StagePlace On(LaneNetwork map, MapLane lane, Vector3D position, MapTurn turn)
    {
        var place = new StagePlace(map, lane, LaneTracks.Chain(lane, LanePoint.Of(lane, position).Along, turn));
        place.FindJunction();
        return place;
    }

    /// <summary>The lane under the track at a distance; null in junctions.</summary>
    /// <param name="at">Metres from the ego's start.</param>
    public MapLane? LaneAt(double at) => _chain.LaneAt(at) is { Junction: null } lane ? lane : null;

    /// <summary>The nearest lane of the other direction beside the track; null if there is none.</summary>
    /// <param name="at">Metres from the ego's start.</param>
    internal LanePoint? OncomingAt(double at)
    {
        Vector3D place = Track.PositionAt(at);
        Vector3D forward = Track.DirectionAt(at);
        return Map
            .Index.Near(place, Reach)
            .Where(lane => lane.Junction is null)
            .Select(lane => LanePoint.Of(lane, place))
            .Where(point =>
                point.Right < 0
                && point.Along > 0
                && point.Along < point.Lane.Length
                && new LaneTrack(point.Lane.Centre).DirectionAt(point.Along).Dot(forward) < -SameWay
            )
            .OrderByDescending(point => point.Right)
            .Cast<LanePoint?>()
            .FirstOrDefault();
    }

    /// <summary>
    /// How far to the right of the track the carriageway ends, metres; negative for the left side; null if that is unknown.
    /// </summary>
    /// <param name="at">Metres from the ego's start.</param>
    /// <param name="side">-1 for the left side, 1 for the right.</param>
    public double? EdgeAt(double at, int side)
    {
        if (LaneAt(at) is not { } lane)
        {
            return null;
        }

        Vector3D place = Track.PositionAt(at);
        if (side < 0 && OncomingAt(at) is { } oncoming)
        {
            LanePoint outer = LanePoint.Of(Outermost(oncoming.Lane, 1), place);
            return outer.Right - (outer.Width / 2);
        }

        LanePoint own = LanePoint.Of(Outermost(lane, side), place);
        return -own.Right + (side * own.Width / 2);
    }

    private static MapLane Outermost(MapLane lane, int side)
    {
        while ((side < 0 ? lane.LeftNeighbour : lane.RightNeighbour) is { } next)
        {
            lane = next;
        }

        return lane;
    }

    private void FindJunction()
    {
        IReadOnlyList<MapLane> lanes = _chain.Lanes;
        for (int i = 1; i < lanes.Count; i++)
        {
            if (_chain.Starts[i] > 0 && lanes[i].Junction is { } number && LaneTracks.IsChoice(lanes[i - 1]))
            {
                int last = i;
                while (last + 1 < lanes.Count && lanes[last + 1].Junction is not null)
                {
                    last++;
                }

                double exit = last + 1 < lanes.Count ? _chain.Starts[last + 1] : Track.To;
                MapJunction junction = Map.Junctions[number];
                var hasLight = new Lazy<bool>(() => HasLight(junction));
                Junction = new StageJunction(junction, _chain.Starts[i], exit, lanes[i - 1], hasLight);
                return;
            }
        }
    }

    private bool HasLight(MapJunction junction)
    {
        const int stopLines = 2;
        Vector3D middle = Map.Network.Nodes[junction.Nodes[0]].Position;
        return Map.Network.Nodes.Count(node =>
                node.Flags.HasFlag(RoadNodeFlags.TrafficLight) && (node.Position - middle).Length < LightRange
            ) >= stopLines;
    }
}
