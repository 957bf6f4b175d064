using Harvester.Geometry.Roads;
using Harvester.Geometry.Work;

namespace Harvester.Geometry.Maps;

/// <summary>
/// The lanes of a network around any place, made where they are asked for: the whole network of a game takes seconds. The lanes around a
/// place are the same as those of the whole network, with the same names, as far as <see cref="ReachMetres"/>. Safe for any number of
/// threads.
/// </summary>
public sealed class LaneMaps
{
    /// <summary>Distance from a place within which the map around it has all lanes, with what precedes and follows them, metres.</summary>
    public const double ReachMetres = 100;

    /// <summary>Side of the squares that share a map, metres.</summary>
    private const double Square = 100;

    /// <summary>Number of squares whose maps are kept: those around a car, and of what it sees at a distance.</summary>
    private const int KeptSquares = 32;

    /// <summary>Number of ways through junctions on the map of everything: several times GTA V's.</summary>
    private const int MaxWays = 150_000;

    /// <summary>The same around a square: several times what GTA V has anywhere.</summary>
    private const int MaxWaysAround = 5000;

    /// <summary>Number of points of a curve from which its bounds follow.</summary>
    private const int BoundSteps = 8;

    private readonly RoadCurves _curves;
    private readonly LaneModel _lanes;
    private readonly JunctionGroups _groups;
    private readonly MapNames _names;
    private readonly int[] _links;
    private readonly int[] _crossings;
    private readonly GroundGrid<(int Link, Box2D Bounds)> _bounds = new(Square);
    private readonly object _lock = new();
    private readonly Dictionary<(double Column, double Row), Lazy<LaneNetwork?>> _made = [];
    private readonly Queue<(double Column, double Row)> _order = new();

    /// <summary>Prepares the maps of a network; a large one takes a moment.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="lanes">The widths of the lanes.</param>
    public LaneMaps(RoadCurves curves, LaneModel lanes)
    {
        _curves = Guard.NotNull(curves, nameof(curves));
        _lanes = Guard.NotNull(lanes, nameof(lanes));
        _groups = new JunctionGroups(curves, lanes);
        RoadNetwork network = curves.Network;
        _links =
        [
            .. Enumerable
                .Range(0, network.Links.Count)
                .Where(link => RoadContinuations.IsDrivable(network, network.Links[link]) && _groups.HasRest(link, curves.Of(link).Length)),
        ];
        _names = new MapNames(network, _links);
        _crossings = [.. CrossingMaker.LinksOf(network)];
        foreach (int link in _links)
        {
            Box2D bounds = BoundsOf(link);
            _bounds.Add((link, bounds), bounds);
        }
    }

    /// <summary>The roads.</summary>
    public RoadNetwork Network => _curves.Network;

    /// <summary>Makes the map of the whole network.</summary>
    /// <param name="content">What it has beside its roads; null for nothing.</param>
    /// <param name="area">The part to keep, as <see cref="LaneNetwork.Of"/> cuts it, metres; null for all.</param>
    /// <exception cref="FormatException">The network has more lanes or ways than a map takes; the message is a sentence.</exception>
    public LaneNetwork Whole(MapContent? content = null, Box2D? area = null)
    {
        var made = new WorkResult<LaneNetwork>();
        WorkRun.Complete(BuilderOf(content ?? MapContent.None, MaxWays).Build(_links, _groups.NodesOf, _crossings, area, made));
        return made.Value!;
    }

    /// <summary>
    /// The map around a place, of the roads alone. Lanes farther away than <see cref="ReachMetres"/> may be missing, also among those that
    /// precede and follow others.
    /// </summary>
    /// <param name="place">Metres, world; the height is ignored.</param>
    /// <returns>The map; null if more roads meet there than a map takes.</returns>
    public LaneNetwork? Around(Vector3D place)
    {
        Guard.Finite(place, nameof(place));
        return MapOf(SquareOf(place));
    }

    /// <summary>Makes the map around a place in steps, unless it is at hand, so that <see cref="Around"/> has it.</summary>
    /// <param name="place">Metres, world; the height is ignored.</param>
    public IEnumerable<WorkStep> MakeAround(Vector3D place)
    {
        Guard.Finite(place, nameof(place));
        return MakeIn(SquareOf(place));
    }

    /// <summary>
    /// Makes the maps around a place and those beside it, so that <see cref="Around"/> has them at hand; may be called on another thread.
    /// </summary>
    /// <param name="place">Metres, world; the height is ignored.</param>
    public void Prepare(Vector3D place)
    {
        Guard.Finite(place, nameof(place));
        for (int column = -1; column <= 1; column++)
        {
            for (int row = -1; row <= 1; row++)
            {
                (double x, double y) = SquareOf(place);
                _ = MapOf((x + column, y + row));
            }
        }
    }

    private static (double Column, double Row) SquareOf(Vector3D place) => (Math.Floor(place.X / Square), Math.Floor(place.Y / Square));

    private LaneNetwork? MapOf((double Column, double Row) square)
    {
        Lazy<LaneNetwork?>? map;
        lock (_lock)
        {
            if (!_made.TryGetValue(square, out map))
            {
                Keep(square, map = new Lazy<LaneNetwork?>(() => Made(square)));
            }
        }

        // Made outside the lock, so that other squares are not waited for.
        return map.Value;
    }

    private LaneNetwork? Made((double Column, double Row) square)
    {
        var made = new WorkResult<LaneNetwork>();
        WorkRun.Complete(Part(square, made));
        return made.Value;
    }

    private IEnumerable<WorkStep> MakeIn((double Column, double Row) square)
    {
        if (!IsMade(square))
        {
            var made = new WorkResult<LaneNetwork>();
            yield return WorkStep.Do(Part(square, made));
            var map = new Lazy<LaneNetwork?>(() => made.Value);
            _ = map.Value;
            lock (_lock)
            {
                Keep(square, map);
            }
        }
    }

    private bool IsMade((double Column, double Row) square)
    {
        lock (_lock)
        {
            return _made.TryGetValue(square, out Lazy<LaneNetwork?>? map) && map.IsValueCreated;
        }
    }

    /// <summary>Keeps a map instead of the oldest; the lock must be held.</summary>
    private void Keep((double Column, double Row) square, Lazy<LaneNetwork?> map)
    {
        if (!_made.ContainsKey(square))
        {
            if (_order.Count == KeptSquares)
            {
                _made.Remove(_order.Dequeue());
            }

            _order.Enqueue(square);
        }

        _made[square] = map;
    }

    /// <summary>Makes the map of a square, in steps; null if more roads meet there than a map takes.</summary>
    private IEnumerable<WorkStep> Part((double Column, double Row) square, WorkResult<LaneNetwork> made)
    {
        var area = new Box2D(
            (square.Column * Square) - ReachMetres,
            (square.Row * Square) - ReachMetres,
            ((square.Column + 1) * Square) + ReachMetres,
            ((square.Row + 1) * Square) + ReachMetres
        );
        var links = new SortedSet<int>(
            _bounds
                .Near((square.Column + 0.5) * Square, (square.Row + 0.5) * Square, (Square / 2) + ReachMetres)
                .Where(road => Meet(road.Bounds, area))
                .Select(road => road.Link)
        );

        // The links that continue these, and the junctions at their ends with all that meets there.
        var junctions = new SortedDictionary<int, List<int>>();
        foreach (int link in links.ToList())
        {
            RoadLink road = Network.Links[link];
            foreach (int node in (int[])[road.From, road.To])
            {
                if (_groups.JunctionOf(node) is { } junction)
                {
                    junctions[junction] = _groups.NodesOf[junction];
                }
                else
                {
                    links.UnionWith(LanesAt(node));
                }
            }
        }

        foreach (int node in junctions.Values.SelectMany(nodes => nodes))
        {
            links.UnionWith(LanesAt(node));
        }

        IEnumerable<int> crossings = _crossings.Where(link =>
            Meet(Between(Network.Nodes[Network.Links[link].From], Network.Nodes[Network.Links[link].To]), area)
        );
        using var build = new WorkRun(
            BuilderOf(MapContent.None, MaxWaysAround).Build(links, junctions, crossings, area: null, made),
            static () => true
        );
        while (Advance(build))
        {
            yield return WorkStep.Pause;
        }
    }

    /// <summary>Whether a work has more steps; not if it passes a limit.</summary>
    private static bool Advance(WorkRun build)
    {
        try
        {
            return build.Advance();
        }
        catch (FormatException)
        {
            return false;
        }
    }

    private IEnumerable<int> LanesAt(int node) => Network.LinksOf(node).Where(link => Array.BinarySearch(_links, link) >= 0);

    private LaneNetworkBuilder BuilderOf(MapContent content, int maxWays) => new(_curves, _lanes, _groups, _names, content, maxWays);

    private static Box2D Between(RoadNode a, RoadNode b) =>
        new(
            Math.Min(a.Position.X, b.Position.X),
            Math.Min(a.Position.Y, b.Position.Y),
            Math.Max(a.Position.X, b.Position.X),
            Math.Max(a.Position.Y, b.Position.Y)
        );

    private static bool Meet(Box2D a, Box2D b) => a.XMin <= b.XMax && a.XMax >= b.XMin && a.YMin <= b.YMax && a.YMax >= b.YMin;

    private Box2D BoundsOf(int link)
    {
        RoadCurve curve = _curves.Of(link);
        Vector3D[] points = [.. Enumerable.Range(0, BoundSteps + 1).Select(step => curve.PointAt(step / (double)BoundSteps))];

        // Between two of the points a cubic bulges by no more than the length of the piece; the lanes reach as far as the outer edge.
        double margin =
            (curve.Length / BoundSteps)
            + Math.Max(_lanes.RightEdgeOf(link, isForward: true) ?? 0, _lanes.RightEdgeOf(link, isForward: false) ?? 0);
        return new Box2D(
            points.Min(point => point.X) - margin,
            points.Min(point => point.Y) - margin,
            points.Max(point => point.X) + margin,
            points.Max(point => point.Y) + margin
        );
    }
}
