using Harvester.Geometry.Roads;
using Harvester.Geometry.Work;

namespace Harvester.Geometry.Maps;

/// <summary>
/// Makes the map of a network, or of some of its links: roads between junctions, their lanes, and the ways through junctions.
/// </summary>
internal sealed class LaneNetworkBuilder
{
    /// <summary>Length of all lanes, metres: several times GTA V's.</summary>
    private const double MaxLaneMetres = 10_000_000;

    /// <summary>Number of roads that meet at a junction: ways are as many as its square.</summary>
    private const int MaxArms = 200;

    /// <summary>Lanes closer together than this have no way between them, metres.</summary>
    private const double MinWay = 0.01;

    private readonly RoadCurves _curves;
    private readonly RoadNetwork _network;
    private readonly LaneModel _lanes;
    private readonly JunctionGroups _groups;
    private readonly MapNames _names;
    private readonly MapContent _content;
    private readonly MarkingFinder _markings;
    private readonly int _maxWays;
    private readonly HashSet<MapLane> _keptLanes = [];
    private readonly Dictionary<int, int> _junctions = [];
    private readonly Dictionary<int, RoadSegment> _segments = [];
    private int _ways;

    public LaneNetworkBuilder(RoadCurves curves, LaneModel lanes, JunctionGroups groups, MapNames names, MapContent content, int maxWays)
    {
        _maxWays = maxWays;
        _curves = curves;
        _network = curves.Network;
        _lanes = lanes;
        _groups = groups;
        _names = names;
        _content = content;
        _markings = new MarkingFinder(curves, lanes, content);
    }

    /// <summary>Makes the map, a road or a junction in a step.</summary>
    /// <param name="links">Its links: some that have lanes outside junctions, ascending.</param>
    /// <param name="nodesOf">
    /// Its junctions: the nodes of each, by the least of them. All links that meet in them must be among those of the map.
    /// </param>
    /// <param name="crossings">The links along which it has pedestrian crossings if no others are known.</param>
    /// <param name="area">The roads that come into it are kept, whole; null for all.</param>
    /// <param name="made">Receives the map.</param>
    /// <exception cref="FormatException">A step passes a limit; the message is a sentence.</exception>
    public IEnumerable<WorkStep> Build(
        IEnumerable<int> links,
        IReadOnlyCollection<KeyValuePair<int, List<int>>> nodesOf,
        IEnumerable<int> crossings,
        Box2D? area,
        WorkResult<LaneNetwork> made
    )
    {
        foreach (KeyValuePair<int, List<int>> junction in nodesOf)
        {
            _junctions.Add(junction.Key, _junctions.Count);
        }

        double metres = 0;
        foreach (int link in links)
        {
            RoadLink road = _network.Links[link];
            metres += (road.LanesForward + road.LanesBackward) * _curves.Of(link).Length;
            Require(
                metres <= MaxLaneMetres,
                FormattableString.Invariant($"the roads have more than {MaxLaneMetres / 1000:0} km of lanes, the limit")
            );
            _segments.Add(link, Segment(link));
            yield return WorkStep.Pause;
        }

        RoadSegment[] segments = [.. _segments.OrderBy(segment => segment.Key).Select(segment => segment.Value)];
        foreach (RoadSegment segment in segments)
        {
            Continue(segment, segment.End, segment.Forward);
            Continue(segment, segment.Start, segment.Backward);
        }

        ILookup<int, JunctionArm> arms = segments
            .SelectMany(segment => JunctionArm.Of(segment, _network.Links[segment.Link]))
            .ToLookup(arm => arm.Junction, arm => arm.Arm);
        var junctions = new List<MapJunction>();
        foreach (KeyValuePair<int, List<int>> group in nodesOf)
        {
            junctions.Add(JunctionOf(group.Key, group.Value, [.. arms[_junctions[group.Key]]]));
            yield return WorkStep.Pause;
        }

        int[] armCounts = [.. Enumerable.Range(0, junctions.Count).Select(junction => arms[junction].Count())];
        made.Value = area is { } box
            ? new LaneNetwork(_network, Within(box, segments), [.. junctions.Select(Cut)], armCounts, _content, crossings, box)
            : new LaneNetwork(_network, segments, junctions, armCounts, _content, crossings, null);
    }

    /// <summary>The roads that come into an area. Their lanes forget the lanes of other roads.</summary>
    private RoadSegment[] Within(Box2D area, RoadSegment[] segments)
    {
        RoadSegment[] kept = [.. segments.Where(segment => IsIn(area, segment))];
        _keptLanes.UnionWith(kept.SelectMany(static segment => segment.Forward.Concat(segment.Backward)));
        foreach (MapLane lane in _keptLanes)
        {
            lane.KeepLinks(other => other.Junction is null ? _keptLanes.Contains(other) : IsKept(other));
        }

        return kept;
    }

    private MapJunction Cut(MapJunction junction) => junction with { Ways = [.. junction.Ways.Where(IsKept)] };

    private bool IsKept(MapLane way) => _keptLanes.Contains(way.Predecessors[0]) && _keptLanes.Contains(way.Successors[0]);

    private static bool IsIn(Box2D area, RoadSegment segment) =>
        segment
            .Forward.Concat(segment.Backward)
            .SelectMany(static lane => lane.Centre)
            .Any(point => point.X >= area.XMin && point.X <= area.XMax && point.Y >= area.YMin && point.Y <= area.YMax);

    private RoadSegment Segment(int link)
    {
        RoadLink road = _network.Links[link];
        RoadCurve curve = _curves.Of(link);
        (double fromStart, double fromEnd) = _groups.TrimsOf(link);
        (double first, double last) = (curve.ParameterAt(fromStart), curve.ParameterAt(curve.Length - fromEnd));
        HermiteCurve line = curve.Between(first, last);
        string name = _names.Segment(link);
        double StationAt(double t) => curve.StationAt(first + ((last - first) * t));
        MapLane[] forward = LanesOf(name, link, line, isForward: true, StationAt);
        MapLane[] backward = LanesOf(name, link, line.Reversed(), isForward: false, t => StationAt(1 - t));
        if (forward.Length > 0 && backward.Length > 0 && !(road.MedianWidth > 0))
        {
            (forward[0].Oncoming, backward[0].Oncoming) = (backward[0], forward[0]);
        }

        var segment = new RoadSegment(
            name,
            link,
            line,
            forward,
            backward,
            EndAt(road.From, _curves.Continuations.Of(link, beyondEnd: false)),
            EndAt(road.To, _curves.Continuations.Of(link, beyondEnd: true))
        )
        {
            Sections = Sections(link, fromStart, curve.Length - fromEnd),
        };
        _markings.Mark(segment, fromStart, curve.Length - fromEnd);
        return segment;
    }

    private SegmentEnd EndAt(int node, int next) =>
        _groups.JunctionOf(node) is { } junction
            ? _junctions.TryGetValue(junction, out int index)
                ? new SegmentEnd(index, null, false)
                : default
            : next == RoadContinuations.None
                ? default
                : new SegmentEnd(null, next, _network.Links[next].From == node);

    /// <summary>The sections of a road between two stations of its link.</summary>
    private SegmentSection[] Sections(int link, double from, double to)
    {
        double[] inner = [.. _lanes.StationsOf(link).Where(station => station > from && station < to)];
        double[] stations = inner.Length == 0 && !_lanes.StationsOf(link).Any() ? [from] : [from, .. inner, to];
        return
        [
            .. stations
                .Distinct()
                .OrderBy(static station => station)
                .Select(station => new SegmentSection(
                    station - from,
                    EdgesOf(link, isForward: true, station),
                    EdgesOf(link, isForward: false, station)
                )),
        ];
    }

    private double[] EdgesOf(int link, bool isForward, double station) =>
        _lanes.LanesOf(link, isForward, station) is { } lanes
            ? [.. Enumerable.Range(0, lanes.Section.LaneCount + 1).Select(edge => lanes.LeftEdge + lanes.Section.Edge(edge))]
            : [];

    private MapLane[] LanesOf(string segment, int link, HermiteCurve line, bool isForward, Func<double, double> stationAt)
    {
        double[] start = EdgesOf(link, isForward, stationAt(0));
        double[] end = EdgesOf(link, isForward, stationAt(1));
        double Edge(int edge, double t) => EdgesOf(link, isForward, stationAt(t))[edge];
        MapLane[] made =
        [
            .. Enumerable
                .Range(0, Math.Max(0, start.Length - 1))
                .Select(index => new MapLane(MapNames.Lane(segment, isForward, index))
                {
                    Link = link,
                    IsForward = isForward,
                    Index = index,
                    StartWidth = start[index + 1] - start[index],
                    EndWidth = end[index + 1] - end[index],
                    StartDirection = Unit(line.VelocityAt(0)),
                    EndDirection = Unit(line.VelocityAt(1)),
                    Left = LanePoints.Beside(line, t => Edge(index, t)),
                    Centre = LanePoints.Beside(line, t => (Edge(index, t) + Edge(index + 1, t)) / 2),
                    Right = LanePoints.Beside(line, t => Edge(index + 1, t)),
                }),
        ];
        for (int i = 1; i < made.Length; i++)
        {
            (made[i].LeftNeighbour, made[i - 1].RightNeighbour) = (made[i - 1], made[i]);
        }

        return made;
    }

    /// <summary>
    /// Connects the lanes of a road to those of the road that continues it: each to the lane of the same number, and where their numbers
    /// differ, to the outermost, so that lanes begin and end on the right.
    /// </summary>
    private void Continue(RoadSegment segment, SegmentEnd end, IReadOnlyList<MapLane> lanes)
    {
        if (end.Link is not { } next || !_segments.TryGetValue(next, out RoadSegment? onwards))
        {
            return;
        }

        IReadOnlyList<MapLane> targets = end.AtStartOfLink ? onwards.Forward : onwards.Backward;
        for (int i = 0; targets.Count > 0 && lanes.Count > 0 && i < Math.Max(lanes.Count, targets.Count); i++)
        {
            lanes[Math.Min(i, lanes.Count - 1)].LeadsTo(targets[Math.Min(i, targets.Count - 1)]);
        }
    }

    private static void Require(bool isTrue, string problem)
    {
        if (!isTrue)
        {
            throw new FormatException(problem + ".");
        }
    }

    private MapJunction JunctionOf(int node, List<int> nodes, JunctionArm[] arms)
    {
        int number = _junctions[node];
        Require(arms.Length <= MaxArms, FormattableString.Invariant($"more than {MaxArms} roads, the limit, meet at the node {node}"));
        var paths = new JunctionPaths(_network, nodes, link => !_groups.HasRest(link, _curves.Of(link).Length));
        MapLane[] ways =
        [
            .. TurnRules
                .Ways(arms, paths)
                .Where(way => (way.To.Centre[0] - way.From.Centre[way.From.Centre.Count - 1]).Length > MinWay)
                .Take(_maxWays - _ways + 1)
                .Select(way => Way(number, way.From, way.To, way.Turn)),
        ];
        _ways += ways.Length;
        Require(_ways <= _maxWays, FormattableString.Invariant($"the roads have more than {_maxWays} ways through junctions, the limit"));

        return new MapJunction(_names.Junction(node), nodes, ways);
    }

    private static MapLane Way(int junction, MapLane from, MapLane to, MapTurn turn)
    {
        HermiteCurve curve = WayCurve.Of(from, to);
        (double start, double end) = (from.EndWidth, to.StartWidth);
        double HalfAt(double t) => (start + ((end - start) * t)) / 2;
        var way = new MapLane($"{from.Id}>{to.Id}")
        {
            Junction = junction,
            Index = from.Index,
            IsForward = true,
            Turn = turn,
            Line = curve,
            StartWidth = start,
            EndWidth = end,
            StartDirection = from.EndDirection,
            EndDirection = to.StartDirection,
            Left = LanePoints.Beside(curve, t => -HalfAt(t)),
            Centre = LanePoints.Beside(curve, static _ => 0),
            Right = LanePoints.Beside(curve, HalfAt),
        };
        from.LeadsTo(way);
        way.LeadsTo(to);
        return way;
    }

    internal static Vector2D Unit(Vector2D vector) => vector.Length > 0 ? vector * (1 / vector.Length) : new Vector2D(0, 1);
}
