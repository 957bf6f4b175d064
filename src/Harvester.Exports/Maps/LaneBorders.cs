using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;

namespace Harvester.Exports.Maps;

/// <summary>
/// The borders of all lanes, such that lanes beside each other have one border in common and lanes that follow each other meet in the
/// same nodes. Where a road's lanes continue with other widths or in another number, the edges of both roads are drawn to the middle
/// between them over <see cref="TaperMetres"/>; of several lanes that lead into one, or follow one, the nearest meets it.
/// </summary>
internal sealed class LaneBorders
{
    /// <summary>The length over which an edge is drawn to where it meets that of the next road, metres; at most half the lane's.</summary>
    public const double TaperMetres = 20;

    /// <summary>Edges of opposite directions that are closer than this at both ends are one border, metres.</summary>
    private const double Touching = 0.001;

    /// <summary>Edges of ways side by side that are closer than this everywhere are one border, metres.</summary>
    private const double SideBySide = 0.05;

    /// <summary>The least distance of the nodes of a border, metres: on the inside of sharp turns, edges shrink to a point.</summary>
    private const double MinStep = 0.05;

    /// <summary>Shorter ways whose inner edge would run back are left out, metres.</summary>
    private const double MinWay = 2;

    /// <summary>How far a border may leave that of the map between its nodes, metres.</summary>
    private const double Tolerance = 0.01;

    private readonly Dictionary<MapLane, BorderSide> _left = [];
    private readonly Dictionary<MapLane, BorderSide> _right = [];
    private readonly List<LaneBorder> _borders = [];
    private readonly List<Vector3D> _nodes = [];
    private readonly Dictionary<int, int> _nodeAt = [];
    private readonly MeetingPoints _places = new();
    private readonly Dictionary<MapLane, MapLane> _joined = [];
    private readonly HashSet<MapLane> _leftOut = [];

    public LaneBorders(LaneNetwork map)
    {
        foreach (RoadSegment segment in map.Segments)
        {
            AddRoad(segment.Forward, segment.Line);
            AddRoad(segment.Backward, segment.Line.Reversed());
        }

        Join(map);
        foreach (MapJunction junction in map.Junctions)
        {
            AddWays(junction);
        }

        BorderEnds.Order(_borders, _places);
        foreach (LaneBorder border in _borders)
        {
            border.Nodes = NodesOf(border);
        }
    }

    /// <summary>The nodes, metres, world.</summary>
    public IReadOnlyList<Vector3D> Nodes => _nodes;

    /// <summary>The borders, each once.</summary>
    public IReadOnlyList<LaneBorder> Borders => _borders;

    /// <summary>The border on the left of a lane.</summary>
    public BorderSide LeftOf(MapLane lane) => _left[lane];

    /// <summary>The border on the right of a lane.</summary>
    public BorderSide RightOf(MapLane lane) => _right[lane];

    /// <summary>Adds a node that no border has, and returns its number.</summary>
    public int AddNode(Vector3D place)
    {
        _nodes.Add(place);
        return _nodes.Count - 1;
    }

    /// <summary>
    /// Whether the middle of a lane does not follow from its borders: the lane turns in less than half its width, or an end was moved.
    /// </summary>
    public bool HasOwnMiddle(MapLane lane) =>
        IsFolded(lane)
        || _places.IsMoved(_left[lane].Start)
        || _places.IsMoved(_left[lane].End)
        || _places.IsMoved(_right[lane].Start)
        || _places.IsMoved(_right[lane].End);

    /// <summary>The middle of a lane, which does not run back where the lane lies inside a bend that is too sharp for it.</summary>
    public IReadOnlyList<Vector3D> MiddleOf(MapLane lane)
    {
        BorderSide right = _right[lane];
        return UnfoldedLine.Of(lane.Centre, right.IsReversed ? [.. right.Border.Axis.Reverse()] : right.Border.Axis);
    }

    private static bool IsFolded(MapLane lane) =>
        UnfoldedLine.IsFolded(lane.Left, lane.Centre) || UnfoldedLine.IsFolded(lane.Right, lane.Centre);

    /// <summary>
    /// The ways that have no borders: those between lanes that meet, where there is no room for a way, and those back into the same lane,
    /// which nobody drives.
    /// </summary>
    public IReadOnlySet<MapLane> LeftOut => _leftOut;

    /// <summary>The lanes that follow a lane, without the ways that are left out.</summary>
    public IEnumerable<MapLane> After(MapLane lane) =>
        lane.Successors.Where(next => !IsLoop(next)).Select(next => _leftOut.Contains(next) ? next.Successors[0] : next);

    /// <summary>The lanes that a lane follows, without the ways that are left out.</summary>
    public IEnumerable<MapLane> Before(MapLane lane) =>
        lane.Predecessors.Where(other => !IsLoop(other)).Select(other => _leftOut.Contains(other) ? other.Predecessors[0] : other);

    /// <summary>Whether a way leads from the end of a lane back to its start.</summary>
    private static bool IsLoop(MapLane lane) => lane.Junction is not null && lane.Predecessors[0] == lane.Successors[0];

    /// <summary>
    /// Joins the end of each lane to the start of one that follows it, the nearest if there are several: one that continues its road, or
    /// one to which the way is too short to have an inner edge.
    /// </summary>
    private void Join(LaneNetwork map)
    {
        var pairs = new List<(MapLane From, MapLane To, MapLane? Way, double Apart)>();
        foreach (MapLane lane in map.Lanes)
        {
            if (lane.Junction is null)
            {
                pairs.AddRange(
                    lane.Successors.Where(next => next.Junction is null).Select(next => (lane, next, (MapLane?)null, Apart(lane, next)))
                );
            }
            else if (IsLoop(lane))
            {
                _leftOut.Add(lane);
            }
            else if (lane.Line!.Value.Length < MinWay && IsFolded(lane))
            {
                pairs.Add((lane.Predecessors[0], lane.Successors[0], lane, Apart(lane.Predecessors[0], lane.Successors[0])));
            }
        }

        var joinedTo = new HashSet<MapLane>();
        foreach ((MapLane from, MapLane to, MapLane? way, double _) in pairs.OrderBy(pair => pair.Apart))
        {
            if (!_joined.ContainsKey(from) && joinedTo.Add(to))
            {
                _joined.Add(from, to);
                _places.Join(_left[from].End, _left[to].Start);
                _places.Join(_right[from].End, _right[to].Start);
                if (way is not null)
                {
                    _leftOut.Add(way);
                }
            }
        }
    }

    private static double Apart(MapLane lane, MapLane next) => (lane.Centre[^1] - next.Centre[0]).Length;

    private void AddRoad(IReadOnlyList<MapLane> lanes, HermiteCurve line)
    {
        if (lanes.Count == 0)
        {
            return;
        }

        // Points of lanes are at even steps of the parameter of the road's line.
        int steps = lanes[0].Centre.Count - 1;
        Vector3D[] axis = [.. Enumerable.Range(0, steps + 1).Select(i => line.PointAt((double)i / steps))];
        BorderSide left = Shared(lanes[0]) ?? Add(LaneBorderKind.Edge, lanes[0].Left, axis);
        left.Border.Marking ??= lanes[0].LeftMarking;
        _left.Add(lanes[0], left);
        for (int i = 0; i < lanes.Count; i++)
        {
            BorderSide right = Add(i < lanes.Count - 1 ? LaneBorderKind.Divider : LaneBorderKind.Edge, lanes[i].Right, axis);
            right.Border.Marking = lanes[i].RightMarking ?? (i < lanes.Count - 1 ? lanes[i + 1].LeftMarking : null);
            _right.Add(lanes[i], right);
            if (i < lanes.Count - 1)
            {
                _left.Add(lanes[i + 1], right);
            }
        }
    }

    /// <summary>The left border of the oncoming lane, if it is that of this lane too.</summary>
    private BorderSide? Shared(MapLane lane)
    {
        if (lane.Oncoming is { } other && _left.TryGetValue(other, out BorderSide side))
        {
            IReadOnlyList<Vector3D> points = side.Border.Points;
            if ((points[0] - lane.Left[^1]).Length < Touching && (points[^1] - lane.Left[0]).Length < Touching)
            {
                side.Border.Kind = LaneBorderKind.Centre;
                return new BorderSide(side.Border, IsReversed: true);
            }
        }

        return null;
    }

    private BorderSide Add(LaneBorderKind kind, IReadOnlyList<Vector3D> points, IReadOnlyList<Vector3D> axis) =>
        Add(kind, points, axis, _places.Add(points[0]), _places.Add(points[^1]));

    private BorderSide Add(LaneBorderKind kind, IReadOnlyList<Vector3D> points, IReadOnlyList<Vector3D> axis, int start, int end)
    {
        var border = new LaneBorder(kind, points, axis, start, end);
        _borders.Add(border);
        return new BorderSide(border, IsReversed: false);
    }

    private void AddWays(MapJunction junction)
    {
        Dictionary<(MapLane, MapLane), MapLane> ways = junction.Ways.ToDictionary(way => (way.Predecessors[0], way.Successors[0]));
        foreach (MapLane way in junction.Ways.Where(way => !_leftOut.Contains(way)).OrderBy(way => way.Index))
        {
            (MapLane from, MapLane to) = (way.Predecessors[0], way.Successors[0]);
            MapLane? beside =
                from.LeftNeighbour is { } left
                && to.LeftNeighbour is { } target
                && ways.TryGetValue((left, target), out MapLane? other)
                && !_leftOut.Contains(other)
                    ? other
                    : null;
            _left.Add(
                way,
                beside is not null && IsSideBySide(beside.Right, way.Left)
                    ? _right[beside]
                    : Add(LaneBorderKind.Junction, way.Left, way.Centre, _left[from].End, _left[to].Start)
            );
            _right.Add(way, Add(LaneBorderKind.Junction, way.Right, way.Centre, _right[from].End, _right[to].Start));
        }
    }

    private static bool IsSideBySide(IReadOnlyList<Vector3D> one, IReadOnlyList<Vector3D> other) =>
        one.Count == other.Count && Enumerable.Range(0, one.Count).All(i => (one[i] - other[i]).Length < SideBySide);

    private List<int> NodesOf(LaneBorder border)
    {
        IReadOnlyList<Vector3D> points = border.Points;
        double[] stations = new double[points.Count];
        for (int i = 1; i < points.Count; i++)
        {
            stations[i] = stations[i - 1] + (points[i] - points[i - 1]).Length;
        }

        (Vector3D start, Vector3D end) = (_places.PositionOf(border.Start), _places.PositionOf(border.End));
        (Vector3D atStart, Vector3D atEnd) = (start - points[0], end - points[^1]);
        double taper = Math.Min(TaperMetres, stations[^1] / 2);
        Vector3D[] tapered = [.. points];
        for (int i = 1; i < points.Count - 1; i++)
        {
            double fromStart = Math.Max(0, 1 - (stations[i] / taper));
            double fromEnd = Math.Max(0, 1 - ((stations[^1] - stations[i]) / taper));
            tapered[i] = points[i] + (atStart * fromStart) + (atEnd * fromEnd);
        }

        (tapered[0], tapered[^1]) = (start, end);
        IReadOnlyList<Vector3D> unfolded = UnfoldedLine.Of(tapered, border.Axis);
        var line = new List<Vector3D> { start };
        line.AddRange(unfolded.Skip(1).SkipLast(1).Where(point => (point - line[^1]).Length >= MinStep && (point - end).Length >= MinStep));
        line.Add(end);
        IReadOnlyList<Vector3D> thinned = ThinnedLine.Of(line, Tolerance);
        var nodes = new List<int> { NodeAt(border.Start, start) };
        for (int i = 1; i < thinned.Count - 1; i++)
        {
            nodes.Add(AddNode(thinned[i]));
        }

        nodes.Add(NodeAt(border.End, end));
        return nodes;
    }

    private int NodeAt(int place, Vector3D position)
    {
        int group = _places.GroupOf(place);
        if (!_nodeAt.TryGetValue(group, out int node))
        {
            _nodeAt.Add(group, node = AddNode(position));
        }

        return node;
    }
}
