using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>
/// The borders of all lanes, such that lanes beside each other have one border in common and lanes that follow each other meet in the
/// same nodes. Where a road's lanes continue with other widths or in another number, the edges of both roads are drawn to the middle
/// between them over <see cref="TaperMetres"/>; a lane that has no lane of its number ahead or behind ends or begins there.
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

    /// <summary>How far a border may leave that of the map between its nodes, metres.</summary>
    private const double Tolerance = 0.01;

    private readonly Dictionary<MapLane, BorderSide> _left = [];
    private readonly Dictionary<MapLane, BorderSide> _right = [];
    private readonly List<LaneBorder> _borders = [];
    private readonly List<Vector3D> _nodes = [];
    private readonly Dictionary<int, int> _nodeAt = [];
    private readonly MeetingPoints _places = new();

    public LaneBorders(LaneNetwork map)
    {
        foreach (RoadSegment segment in map.Segments)
        {
            AddRoad(segment.Forward);
            AddRoad(segment.Backward);
        }

        foreach (MapLane lane in map.Lanes.Where(lane => lane.Junction is null))
        {
            foreach (MapLane next in lane.Successors.Where(next => next.Junction is null && IsContinuation(lane, next)))
            {
                _places.Join(_left[lane].End, _left[next].Start);
                _places.Join(_right[lane].End, _right[next].Start);
            }
        }

        foreach (MapJunction junction in map.Junctions)
        {
            AddWays(junction);
        }

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

    /// <summary>Whether a lane turns in less than half its width, so that its middle does not follow from its borders.</summary>
    public static bool IsFolded(MapLane lane) =>
        FoldedLine.IsFolded(lane.Left, lane.Centre) || FoldedLine.IsFolded(lane.Right, lane.Centre);

    /// <summary>Whether the end of a lane and the start of one that follows it are the same nodes.</summary>
    public static bool IsContinuation(MapLane lane, MapLane next) =>
        lane.Junction is not null || next.Junction is not null || lane.Index == next.Index;

    private void AddRoad(IReadOnlyList<MapLane> lanes)
    {
        if (lanes.Count == 0)
        {
            return;
        }

        BorderSide left = Shared(lanes[0]) ?? Add(LaneBorderKind.Edge, lanes[0].Left);
        left.Border.Marking ??= lanes[0].LeftMarking;
        _left.Add(lanes[0], left);
        for (int i = 0; i < lanes.Count; i++)
        {
            BorderSide right = Add(i < lanes.Count - 1 ? LaneBorderKind.Divider : LaneBorderKind.Edge, lanes[i].Right);
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

    private BorderSide Add(LaneBorderKind kind, IReadOnlyList<Vector3D> points) =>
        Add(kind, points, _places.Add(points[0]), _places.Add(points[^1]));

    private BorderSide Add(LaneBorderKind kind, IReadOnlyList<Vector3D> points, int start, int end)
    {
        var border = new LaneBorder(kind, points, start, end);
        _borders.Add(border);
        return new BorderSide(border, IsReversed: false);
    }

    private void AddWays(MapJunction junction)
    {
        Dictionary<(MapLane, MapLane), MapLane> ways = junction.Ways.ToDictionary(way => (way.Predecessors[0], way.Successors[0]));
        foreach (MapLane way in junction.Ways.OrderBy(way => way.Index))
        {
            (MapLane from, MapLane to) = (way.Predecessors[0], way.Successors[0]);
            MapLane? beside =
                from.LeftNeighbour is { } left && to.LeftNeighbour is { } target && ways.TryGetValue((left, target), out MapLane? other)
                    ? other
                    : null;
            _left.Add(
                way,
                beside is not null && IsSideBySide(beside.Right, way.Left)
                    ? _right[beside]
                    : Add(LaneBorderKind.Junction, Trimmed(way.Left, way), _left[from].End, _left[to].Start)
            );
            _right.Add(way, Add(LaneBorderKind.Junction, Trimmed(way.Right, way), _right[from].End, _right[to].Start));
        }
    }

    private static IReadOnlyList<Vector3D> Trimmed(IReadOnlyList<Vector3D> edge, MapLane way) =>
        FoldedLine.IsFolded(edge, way.Centre) ? FoldedLine.Trimmed(edge) : edge;

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
        var line = new List<Vector3D> { start };
        for (int i = 1; i < points.Count - 1; i++)
        {
            double fromStart = Math.Max(0, 1 - (stations[i] / taper));
            double fromEnd = Math.Max(0, 1 - ((stations[^1] - stations[i]) / taper));
            Vector3D point = points[i] + (atStart * fromStart) + (atEnd * fromEnd);
            if ((point - line[^1]).Length >= MinStep && (point - end).Length >= MinStep)
            {
                line.Add(point);
            }
        }

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
