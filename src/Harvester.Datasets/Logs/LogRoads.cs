using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Logs;

/// <summary>
/// Makes roads of the lanes of a log: each lane is a one-way road of one narrow lane through points on its middle, because logs tell where
/// lanes are and not which carriageway they belong to.
/// </summary>
internal sealed class LogRoads
{
    /// <summary>WOMD's number of a lane for bicycles, and of one of a freeway.</summary>
    private const int BicycleLane = 3;
    private const int Freeway = 1;

    /// <summary>Greatest distance between nodes, metres: a curve of a car's least radius, 6 m, leaves the cubic between them by
    /// centimetres.</summary>
    private const double Spacing = 6;

    /// <summary>Ends of lanes that are no farther apart than this are one node, metres: less than half of the narrowest lane.</summary>
    private const double SameEnd = 0.6;

    /// <summary>A shorter lane is left out, metres.</summary>
    private const double MinLength = 1;

    private readonly List<Vector3D> _nodes = [];
    private readonly List<RoadNodeFlags> _flags = [];
    private readonly List<RoadLink> _links = [];
    private readonly List<(Vector3D End, int Node)> _ends = [];
    private readonly Dictionary<(long X, long Y), List<int>> _cells = [];
    private readonly List<(LogFeature Lane, int First, int Count)> _lanes = [];

    private LogRoads(MotionLog log)
    {
        foreach (LogFeature lane in log.Features.Where(feature => feature.Kind == LogFeatureKind.Lane))
        {
            if (lane.Type == BicycleLane)
            {
                BicycleLanes++;
            }
            else if (!Add(lane))
            {
                ShortLanes++;
            }
        }

        Network = new RoadNetwork(
            [.. _nodes.Select((place, index) => new RoadNode(RoadNode.NoArea, index, place, "", _flags[index]))],
            _links
        );
    }

    /// <summary>The roads.</summary>
    public RoadNetwork Network { get; }

    /// <summary>Number of lanes for bicycles, which are left out.</summary>
    public int BicycleLanes { get; }

    /// <summary>Number of lanes that are left out because they are too short for a road.</summary>
    public int ShortLanes { get; }

    /// <summary>Number of lanes that became roads.</summary>
    public int Lanes => _lanes.Count;

    /// <summary>Makes the roads of a log.</summary>
    public static LogRoads Of(MotionLog log) => new(log);

    /// <summary>How far the log's points of lanes lie from the middles of their roads on the ground, metres, ascending.</summary>
    public double[] Deviations()
    {
        var curves = new RoadCurves(Network);
        return
        [
            .. _lanes
                .SelectMany(lane =>
                    lane.Lane.Points.Select(point =>
                        Enumerable.Range(lane.First, lane.Count).Min(link => Distance(curves.Of(link), new Vector2D(point.X, point.Y)))
                    )
                )
                .Order(),
        ];
    }

    private static double Distance(RoadCurve curve, Vector2D place)
    {
        Vector3D nearest = curve.PointAt(curve.ClosestParameter(place));
        return new Vector2D(nearest.X - place.X, nearest.Y - place.Y).Length;
    }

    private bool Add(LogFeature lane)
    {
        IReadOnlyList<Vector3D> points = lane.Points;
        var stations = new double[points.Count];
        for (int i = 1; i < points.Count; i++)
        {
            stations[i] = stations[i - 1] + Ground(points[i] - points[i - 1]).Length;
        }

        double length = stations[^1];
        if (length < MinLength)
        {
            return false;
        }

        int first = EndNode(points[0]);
        int last = EndNode(points[^1]);
        int pieces = Math.Max(first == last ? 2 : 1, (int)Math.Ceiling(length / Spacing));
        RoadNodeFlags flags = lane.Type == Freeway ? RoadNodeFlags.Highway : RoadNodeFlags.None;
        int from = first;
        int link = _links.Count;
        for (int piece = 1; piece <= pieces; piece++)
        {
            int to = piece == pieces ? last : AddNode(At(points, stations, length * piece / pieces));
            _flags[from] |= flags;
            _flags[to] |= flags;
            _links.Add(new RoadLink(from, to, 1, 0, null, RoadLinkFlags.NarrowRoad));
            from = to;
        }

        _lanes.Add((lane, link, pieces));
        return true;
    }

    /// <summary>The node at an end of lanes.</summary>
    private int EndNode(Vector3D place)
    {
        (long x, long y) = ((long)Math.Floor(place.X / SameEnd), (long)Math.Floor(place.Y / SameEnd));
        for (long i = x - 1; i <= x + 1; i++)
        {
            for (long j = y - 1; j <= y + 1; j++)
            {
                foreach (int end in _cells.GetValueOrDefault((i, j)) ?? [])
                {
                    if ((_ends[end].End - place).Length <= SameEnd)
                    {
                        return _ends[end].Node;
                    }
                }
            }
        }

        int node = AddNode(place);
        if (!_cells.TryGetValue((x, y), out List<int>? cell))
        {
            _cells.Add((x, y), cell = []);
        }

        cell.Add(_ends.Count);
        _ends.Add((place, node));
        return node;
    }

    private int AddNode(Vector3D place)
    {
        _nodes.Add(place);
        _flags.Add(RoadNodeFlags.None);
        return _nodes.Count - 1;
    }

    private static Vector3D At(IReadOnlyList<Vector3D> points, double[] stations, double station)
    {
        int after = Math.Clamp(Array.FindIndex(stations, place => place >= station), 1, points.Count - 1);
        double piece = stations[after] - stations[after - 1];
        double part = piece > 0 ? (station - stations[after - 1]) / piece : 0;
        return points[after - 1] + ((points[after] - points[after - 1]) * Math.Clamp(part, 0, 1));
    }

    private static Vector2D Ground(Vector3D vector) => new(vector.X, vector.Y);
}
