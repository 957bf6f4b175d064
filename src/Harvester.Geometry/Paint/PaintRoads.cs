using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// A road network prepared for the search of paint: which links are near, and how far to each side of a link's curve its own carriageway
/// may reach. Immutable, and so safe for any number of threads.
/// </summary>
public sealed class PaintRoads
{
    /// <summary>Widest lane, metres; wider ones are not known in the game.</summary>
    private const double MaxLaneWidth = 6.5;

    /// <summary>Shoulder and parking strip beyond the lanes, metres.</summary>
    private const double MaxShoulder = 3;

    /// <summary>Step in which a carriageway's reach is found, metres.</summary>
    private const double ReachStep = 0.5;

    /// <summary>Stations between two places at which the reach is found, metres.</summary>
    private const double StationStep = 2;

    /// <summary>Roads farther above or below than this do not bound a carriageway, metres.</summary>
    private const double SameLevel = 4;

    private readonly RoadIndex _index;
    private readonly Lazy<(float Left, float Right)[]>[] _reaches;

    /// <summary>Prepares a network.</summary>
    /// <param name="curves">The centre lines.</param>
    public PaintRoads(RoadCurves curves)
    {
        Curves = Guard.NotNull(curves, nameof(curves));
        Junctions = new JunctionExtents(curves, new LaneModel(curves.Network));
        _index = new RoadIndex(curves, _ => PaintScanner.MaxDistance);
        Mouths = new JunctionMouths(this);
        _reaches = new Lazy<(float, float)[]>[curves.Network.Links.Count];
        for (int i = 0; i < _reaches.Length; i++)
        {
            int link = i;
            _reaches[i] = new(() => ReachesOf(link));
        }
    }

    /// <summary>The centre lines.</summary>
    public RoadCurves Curves { get; }

    /// <summary>The extents of junctions.</summary>
    public JunctionExtents Junctions { get; }

    /// <summary>The mouths of roads at junctions.</summary>
    internal JunctionMouths Mouths { get; }

    /// <summary>Number of rows of a link.</summary>
    /// <param name="link">Index of the link.</param>
    public int RowsOf(int link) => Math.Max(1, (int)(Curves.Of(link).Length / PaintRow.Length));

    /// <summary>The station in the middle of a row, metres from the link's start.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="row">Number of the row.</param>
    public double StationOf(int link, int row) => (row + 0.5) * Curves.Of(link).Length / RowsOf(link);

    /// <summary>The height of the nearest road at a place, metres; null if none is near.</summary>
    /// <param name="place">Metres, world.</param>
    public double? HeightAt(Vector3D place)
    {
        double? height = null;
        double least = PaintScanner.MaxDistance;
        var ground = new Vector2D(place.X, place.Y);
        foreach (int link in (IEnumerable<int>)_index.Near(place))
        {
            RoadCurve curve = Curves.Of(link);
            if (curve.IsBeyond(ground, least))
            {
                continue;
            }

            Vector3D nearest = curve.PointAt(curve.ClosestParameter(ground));
            double distance = new Vector2D(nearest.X - place.X, nearest.Y - place.Y).Length;
            if (distance < least && Math.Abs(nearest.Z - place.Z) <= SameLevel)
            {
                least = distance;
                height = nearest.Z;
            }
        }

        return height;
    }

    /// <summary>The drivable links within reach of a camera, and possibly some a little farther away, by their index.</summary>
    internal ArraySegment<int> Near(Vector3D place) => _index.Near(place);

    /// <summary>How far the carriageway of a link may reach at a station: offsets to the right of its curve, metres.</summary>
    internal (float Left, float Right) ReachAt(int link, double station)
    {
        (float, float)[] reaches = _reaches[link].Value;
        return reaches[Math.Min(reaches.Length - 1, (int)(station / StationStep))];
    }

    private (float Left, float Right)[] ReachesOf(int link)
    {
        RoadCurve curve = Curves.Of(link);
        RoadLink road = Curves.Network.Links[link];
        double half =
            (MaxLaneWidth * (road.LanesForward + road.LanesBackward) / (road.IsOneWay ? 2 : 1))
            + MaxShoulder
            + ((road.MedianWidth ?? 0) / 2);
        var reaches = new (float, float)[Math.Max(1, (int)Math.Ceiling(curve.Length / StationStep))];
        for (int i = 0; i < reaches.Length; i++)
        {
            double parameter = curve.ParameterAt(Math.Min(curve.Length, (i + 0.5) * StationStep));
            reaches[i] = ((float)-Reach(link, parameter, -1, half), (float)Reach(link, parameter, 1, half));
        }

        return reaches;
    }

    /// <summary>The distance to one side up to which the link is nearer than every other that does not continue it.</summary>
    private double Reach(int link, double parameter, int side, double half)
    {
        double reach = ReachStep;
        while (reach < half && IsNearest(link, Curves.Of(link).PointBeside(parameter, side * reach), reach))
        {
            reach += ReachStep;
        }

        return Math.Min(half, reach);
    }

    private bool IsNearest(int link, Vector3D place, double distance)
    {
        foreach (int other in (IEnumerable<int>)_index.Near(place))
        {
            RoadCurve curve = Curves.Of(other);
            var ground = new Vector2D(place.X, place.Y);
            if (
                other == link
                || Curves.Continuations.Of(link, false) == other
                || Curves.Continuations.Of(link, true) == other
                || curve.IsBeyond(ground, distance)
            )
            {
                continue;
            }

            Vector3D nearest = curve.PointAt(curve.ClosestParameter(ground));
            if (Math.Abs(nearest.Z - place.Z) <= SameLevel && new Vector2D(nearest.X - place.X, nearest.Y - place.Y).Length < distance)
            {
                return false;
            }
        }

        return true;
    }
}
