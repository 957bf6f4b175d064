using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>
/// The lanes of a road network, and which follows which. What a lane is follows from the road data: its line from the nodes, its edges from
/// the lane model, and the ways through junctions from where roads lead, so that ways are derived, not known.
/// </summary>
public sealed class LaneNetwork
{
    /// <summary>Side of the cells in which the roads to junctions are found, metres.</summary>
    private const double ApproachCell = 64;

    /// <summary>How far a place beside a lane may lie before its start or past its end, metres: room for a bend between lanes.</summary>
    private const double MaxBeyond = 0.5;

    private readonly Dictionary<string, MapLane> _byId;
    private readonly GroundGrid<LaneApproach> _approachGrid = new(ApproachCell);
    private readonly Dictionary<MapLane, LaneApproach> _approachOf = [];
    private readonly IReadOnlyList<int> _arms;

    internal LaneNetwork(
        RoadNetwork network,
        IReadOnlyList<RoadSegment> segments,
        IReadOnlyList<MapJunction> junctions,
        IReadOnlyList<int> arms,
        MapContent content,
        IEnumerable<int> crossings,
        Box2D? area
    )
    {
        (Network, Segments, Junctions, _arms) = (network, segments, junctions, arms);
        Lanes =
        [
            .. segments.SelectMany(segment => segment.Forward.Concat(segment.Backward)),
            .. junctions.SelectMany(junction => junction.Ways),
        ];
        for (int i = 0; i < Lanes.Count; i++)
        {
            Lanes[i].Order = i;
        }

        _byId = Lanes.ToDictionary(lane => lane.Id, StringComparer.Ordinal);
        Index = new LaneIndex(this);
        Approaches = [.. LaneApproach.Of(segments)];
        foreach (LaneApproach approach in Approaches)
        {
            Vector3D end = approach.Left;
            _approachGrid.Add(approach, new Box2D(end.X, end.Y, end.X, end.Y));
            foreach (MapLane lane in approach.Lanes)
            {
                _approachOf.Add(lane, approach);
            }
        }

        (PaintedMark, MapSource)[] marks =
        [
            .. content.KnownMarks.Select(mark => (mark, MapSource.Known)),
            .. (content.Paint?.Marks ?? []).Select(mark => (mark.Mark, MapSource.Measured)),
        ];
        bool IsIn(Vector3D place) =>
            area is not { } box || (place.X >= box.XMin && place.X <= box.XMax && place.Y >= box.YMin && place.Y <= box.YMax);
        SpeedLimits.Apply(this, content.SpeedSigns);
        Signals = [.. SignalMaker.Make(this, content.Props).Where(signal => signal.Lanes.Count > 0 || IsIn(signal.Position))];
        StopLines = new StopLineMaker(this).Make(marks);
        Crossings = [.. CrossingMaker.Make(network, crossings, marks).Where(crossing => crossing.Corners.Any(IsIn))];
    }

    /// <summary>The roads.</summary>
    public RoadNetwork Network { get; }

    /// <summary>The roads outside junctions, in the order of their links.</summary>
    public IReadOnlyList<RoadSegment> Segments { get; }

    /// <summary>The junctions; on a map of an area, those outside it have no ways.</summary>
    public IReadOnlyList<MapJunction> Junctions { get; }

    /// <summary>All lanes: those of <see cref="Segments"/>, then the ways through <see cref="Junctions"/>.</summary>
    public IReadOnlyList<MapLane> Lanes { get; }

    /// <summary>The traffic lights and the signs that say who waits, in the order in which they were given.</summary>
    public IReadOnlyList<MapSignal> Signals { get; }

    /// <summary>The stop lines: those that are painted, then those that are derived.</summary>
    public IReadOnlyList<MapStopLine> StopLines { get; }

    /// <summary>The pedestrian crossings: those that are painted, then those that are derived.</summary>
    public IReadOnlyList<MapCrossing> Crossings { get; }

    /// <summary>Finds lanes by their place.</summary>
    public LaneIndex Index { get; }

    internal IReadOnlyList<LaneApproach> Approaches { get; }

    /// <summary>Makes the map of a network.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="lanes">The widths of the lanes.</param>
    /// <param name="content">What the map has beside its roads; null for nothing.</param>
    /// <param name="area">
    /// Part of the world, metres; null for all. Roads that come into it are kept from end to end, as they are on the map of everything;
    /// at its border, lanes end without successors. Ways are kept if both their lanes are, and of the rest what lies in the area or
    /// governs a lane that is kept.
    /// </param>
    /// <exception cref="FormatException">The network has more lanes or ways than a map takes; the message is a sentence.</exception>
    public static LaneNetwork Of(RoadCurves curves, LaneModel lanes, MapContent? content = null, Box2D? area = null) =>
        new LaneMaps(curves, lanes).Whole(content, area);

    /// <summary>A lane by its name; null if there is none.</summary>
    public MapLane? Find(string id) => _byId.TryGetValue(id, out MapLane? lane) ? lane : null;

    /// <summary>A lane by its link and number.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="isForward">Whether the lane runs from the link's start to its end.</param>
    /// <param name="index">Its number in its direction, 0 the leftmost.</param>
    /// <param name="beside">A place on the link, metres, world.</param>
    /// <returns>The lane; null if it does not lie beside the place, as in a junction.</returns>
    public MapLane? LaneOf(int link, bool isForward, int index, Vector3D beside)
    {
        if (RoadOf(link) is not { } road)
        {
            return null;
        }

        IReadOnlyList<MapLane> lanes = isForward ? road.Forward : road.Backward;
        return index < lanes.Count && LanePiece.NearestOf(lanes[index], beside).Beyond <= MaxBeyond ? lanes[index] : null;
    }

    /// <summary>The road of a link, by bisection; null if the map has none.</summary>
    private RoadSegment? RoadOf(int link)
    {
        (int from, int to) = (0, Segments.Count);
        while (from < to)
        {
            int middle = (from + to) / 2;
            (from, to) = Segments[middle].Link < link ? (middle + 1, to) : (from, middle);
        }

        return from < Segments.Count && Segments[from].Link == link ? Segments[from] : null;
    }

    /// <summary>The number of roads that meet in a junction.</summary>
    internal int ArmsOf(int junction) => _arms[junction];

    /// <summary>The lanes with which a lane leads into a junction; null if it does not.</summary>
    internal LaneApproach? ApproachOf(MapLane lane) => _approachOf.TryGetValue(lane, out LaneApproach? approach) ? approach : null;

    internal IEnumerable<LaneApproach> ApproachesNear(Vector3D place, double range) => _approachGrid.Near(place.X, place.Y, range);
}
