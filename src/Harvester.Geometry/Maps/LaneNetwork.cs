using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>
/// The lanes of a road network, and which follows which. What a lane is follows from the road data: its line from the nodes, its edges from
/// the lane model, and the ways through junctions from where roads lead, so that ways are derived, not known.
/// </summary>
public sealed class LaneNetwork
{
    private readonly Dictionary<string, MapLane> _byId;

    internal LaneNetwork(RoadNetwork network, IReadOnlyList<RoadSegment> segments, IReadOnlyList<MapJunction> junctions)
    {
        (Network, Segments, Junctions) = (network, segments, junctions);
        Lanes =
        [
            .. segments.SelectMany(segment => segment.Forward.Concat(segment.Backward)),
            .. junctions.SelectMany(junction => junction.Ways),
        ];
        _byId = Lanes.ToDictionary(lane => lane.Id, StringComparer.Ordinal);
    }

    /// <summary>The roads.</summary>
    public RoadNetwork Network { get; }

    /// <summary>The roads outside junctions, in the order of their links.</summary>
    public IReadOnlyList<RoadSegment> Segments { get; }

    /// <summary>The junctions.</summary>
    public IReadOnlyList<MapJunction> Junctions { get; }

    /// <summary>All lanes: those of <see cref="Segments"/>, then the ways through <see cref="Junctions"/>.</summary>
    public IReadOnlyList<MapLane> Lanes { get; }

    /// <summary>Makes the map of a network.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="lanes">The widths of the lanes.</param>
    public static LaneNetwork Of(RoadCurves curves, LaneModel lanes) => new LaneNetworkBuilder(curves, lanes).Build();

    /// <summary>A lane by its name; null if there is none.</summary>
    public MapLane? Find(string id) => _byId.TryGetValue(id, out MapLane? lane) ? lane : null;
}
