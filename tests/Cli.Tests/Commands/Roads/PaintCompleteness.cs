using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>How much of what is painted along roads, without junctions, a table of measured paint has.</summary>
internal sealed class PaintCompleteness
{
    /// <summary>A painted point is found if a measured one is nearer than this, metres: those are 1 m apart.</summary>
    private const double MaxDistance = 1;

    /// <summary>A painted point belongs to a road that is nearer than this, metres: half of the widest carriageway.</summary>
    private const double MaxOffset = 25;

    private readonly ILookup<(int X, int Y), Vector3D> _measured;
    private readonly RoadCurves _curves;
    private readonly JunctionExtents _junctions;
    private readonly RoadIndex _index;

    public PaintCompleteness(PaintTable table, RoadCurves curves)
    {
        _curves = curves;
        _junctions = new JunctionExtents(curves, new LaneModel(curves.Network));
        _index = new RoadIndex(curves, _ => MaxOffset);
        _measured = table
            .Links.SelectMany(link => link.Lines.SelectMany(line => Samples(line, curves.Of(link.Link))))
            .ToLookup(place => CellOf(place));
    }

    /// <summary>Metres of paint.</summary>
    public int Painted { get; private set; }

    /// <summary>Metres of paint that the table has.</summary>
    public int Found { get; private set; }

    /// <summary>Counts the paint within a distance of a place.</summary>
    public void Judge(IEnumerable<PaintedLine> painted, Vector2D near, double range)
    {
        foreach (PaintedLine line in painted)
        {
            double rest = 0;
            for (int i = 0; i + 1 < line.Points.Count; i++)
            {
                (Vector3D a, Vector3D b) = (line.Points[i].World, line.Points[i + 1].World);
                double length = (b - a).Length;
                for (; rest < length; rest++)
                {
                    Vector3D place = a + ((b - a) * (rest / length));
                    if ((new Vector2D(place.X, place.Y) - near).Length < range && IsOnRoad(place))
                    {
                        Painted++;
                        Found += IsFound(place) ? 1 : 0;
                    }
                }

                rest -= length;
            }
        }
    }

    /// <summary>Whether the nearest road has no junction at a place.</summary>
    private bool IsOnRoad(Vector3D place)
    {
        var ground = new Vector2D(place.X, place.Y);
        (int link, double station, double distance) = (-1, 0, MaxOffset);
        foreach (int near in _index.Near(place))
        {
            RoadCurve curve = _curves.Of(near);
            double parameter = curve.ClosestParameter(ground);
            Vector3D apart = curve.PointAt(parameter) - place;
            double away = new Vector2D(apart.X, apart.Y).Length;
            (link, station, distance) = away < distance ? (near, curve.StationAt(parameter), away) : (link, station, distance);
        }

        return link >= 0 && !_junctions.Contains(link, station);
    }

    private bool IsFound(Vector3D place)
    {
        (int x, int y) = CellOf(place);
        return Enumerable
            .Range(0, 9)
            .SelectMany(i => _measured[(x + (i % 3) - 1, y + (i / 3) - 1)])
            .Any(measured => new Vector2D(measured.X - place.X, measured.Y - place.Y).Length < MaxDistance);
    }

    private static IEnumerable<Vector3D> Samples(LinePaint line, RoadCurve curve)
    {
        int samples = Math.Max(1, (int)Math.Ceiling(line.ToStation - line.FromStation));
        return Enumerable
            .Range(0, samples + 1)
            .Select(i => line.FromStation + (i * (line.ToStation - line.FromStation) / samples))
            .Select(station => curve.PointBeside(curve.ParameterAt(station), line.OffsetAt(station)));
    }

    private static (int X, int Y) CellOf(Vector3D place) => ((int)Math.Floor(place.X), (int)Math.Floor(place.Y));
}
