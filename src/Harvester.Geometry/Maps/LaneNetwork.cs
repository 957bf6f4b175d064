using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>
/// The lanes of a road network, and which follows which. What a lane is follows from the road data: its line from the nodes, its edges from
/// the lane model, and the ways through junctions from where roads lead, so that ways are derived, not known.
/// </summary>
public sealed class LaneNetwork
{
    private readonly Dictionary<string, MapLane> _byId;
    private readonly Lazy<LaneSearch> _search;

    internal LaneNetwork(RoadNetwork network, IReadOnlyList<RoadSegment> segments, IReadOnlyList<MapJunction> junctions)
    {
        (Network, Segments, Junctions) = (network, segments, junctions);
        Lanes =
        [
            .. segments.SelectMany(segment => segment.Forward.Concat(segment.Backward)),
            .. junctions.SelectMany(junction => junction.Ways),
        ];
        _byId = Lanes.ToDictionary(lane => lane.Id, StringComparer.Ordinal);
        _search = new Lazy<LaneSearch>(() => new LaneSearch(Lanes, segments));
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
    public static LaneNetwork Of(RoadCurves curves, LaneModel lanes) => new LaneMaps(curves, lanes).Whole();

    /// <summary>A lane by its name; null if there is none.</summary>
    public MapLane? Find(string id) => _byId.TryGetValue(id, out MapLane? lane) ? lane : null;

    /// <summary>A lane of a road by its place on the network; null if none of it lies outside junctions.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="isForward">Whether it runs from the link's start to its end.</param>
    /// <param name="index">Its number in its direction, 0 the leftmost.</param>
    public MapLane? LaneOf(int link, bool isForward, int index) =>
        _search.Value.SegmentOf(link) is { } segment && (isForward ? segment.Forward : segment.Backward) is var lanes && index < lanes.Count
            ? lanes[index]
            : null;

    /// <summary>The lane or way on which something is.</summary>
    /// <param name="position">Metres, world, at most 4 m above or below the road.</param>
    /// <param name="direction">Its direction on the ground, of any length; it may differ from that of the lane by 60 degrees.</param>
    /// <returns>
    /// The one whose middle and direction fit best: where ways through a junction part, the place does not tell them apart. Null if it is
    /// on none.
    /// </returns>
    public MapLane? At(Vector3D position, Vector2D direction) => _search.Value.At(position, direction);

    /// <summary>The lanes that can be reached from a place on a lane without turning back or changing lanes.</summary>
    /// <param name="from">The lane.</param>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">How far ahead of the place a lane may begin, metres.</param>
    /// <returns>The lanes and ways, the nearest first, without the lane itself.</returns>
    public static IReadOnlyList<MapLane> Ahead(MapLane from, Vector3D place, double range)
    {
        Guard.NotNull(from, nameof(from));
        var begins = new Dictionary<MapLane, double>();
        var found = new List<MapLane>();
        var open = new SortedSet<(double Metres, string Id)>();
        var lanes = new Dictionary<string, MapLane>(StringComparer.Ordinal);
        Reach(from, from.Length - from.NearestTo(place).Point.Along);
        while (open.Count > 0)
        {
            (double metres, string id) = open.Min;
            open.Remove(open.Min);
            MapLane lane = lanes[id];
            if (begins[lane] == metres)
            {
                found.Add(lane);
                Reach(lane, metres + lane.Length);
            }
        }

        return found;

        void Reach(MapLane lane, double end)
        {
            foreach (MapLane next in lane.Successors.Where(next => next != from && end <= range))
            {
                if (!begins.TryGetValue(next, out double before) || end < before)
                {
                    begins[next] = end;
                    lanes[next.Id] = next;
                    open.Add((end, next.Id));
                }
            }
        }
    }
}
