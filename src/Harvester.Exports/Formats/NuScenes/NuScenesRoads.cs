using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>
/// The drivable ground of a road network, as polygons: the lanes and shoulders of each road without a wide median, and the junctions
/// between them.
/// </summary>
internal sealed class NuScenesRoads
{
    /// <summary>Length of the pieces of a road, metres: the edge of a bend of 30 m radius is drawn to 7 cm.</summary>
    private const double PieceMetres = 4;

    /// <summary>Paved ground beside the lanes, metres: the hard shoulder of a highway, and the edge of any other road.</summary>
    private const double HardShoulder = 2.5;
    private const double Edge = 0.4;

    /// <summary>Least width of a median that is not driven on, metres: narrower ones are painted.</summary>
    private const double NarrowestIsland = 1.5;

    /// <summary>Number of sides of the round plate that closes the gap between the ends of two roads.</summary>
    private const int PlateSides = 16;

    private readonly RoadNetwork _network;
    private readonly RoadCurves _curves;
    private readonly LaneModel _lanes;
    private readonly JunctionExtents _junctions;

    /// <summary>Prepares the roads of a session.</summary>
    public NuScenesRoads(RoadNetwork network, LaneWidths widths)
    {
        _network = network;
        _curves = new RoadCurves(network);
        _lanes = new LaneModel(network, widths.Ordinary, widths.Narrow);
        _junctions = new JunctionExtents(_curves, _lanes);
    }

    /// <summary>The polygons near a place, metres, world. A polygon is the same for every place.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="distance">How far the middle of a polygon may be away, metres.</param>
    public IEnumerable<Vector2D[]> Near(Vector2D place, double distance)
    {
        var nodes = new SortedSet<int>();
        for (int link = 0; link < _network.Links.Count; link++)
        {
            RoadCurve curve = _curves.Of(link);
            if (
                !RoadContinuations.IsDrivable(_network, _network.Links[link])
                || Math.Min(Apart(curve.PointAt(0)), Apart(curve.PointAt(1))) > distance + curve.Length
            )
            {
                continue;
            }

            nodes.UnionWith([_network.Links[link].From, _network.Links[link].To]);
            int pieces = Math.Max(1, (int)Math.Ceiling(curve.Length / PieceMetres));
            for (int piece = 0; piece < pieces; piece++)
            {
                double middle = curve.Length * (piece + 0.5) / pieces;
                if (Apart(curve.PointAt(curve.ParameterAt(middle))) <= distance)
                {
                    foreach ((double left, double right) in StripsAt(link, middle))
                    {
                        yield return Piece(curve, curve.Length * piece / pieces, curve.Length * (piece + 1) / pieces, left, right);
                    }
                }
            }
        }

        foreach (Vector2D[] polygon in nodes.Where(node => Apart(_network.Nodes[node].Position) <= distance).SelectMany(AtNode))
        {
            yield return polygon;
        }

        double Apart(Vector3D point) => (Ground(point) - place).Length;
    }

    private static Vector2D[] Piece(RoadCurve curve, double from, double to, double left, double right)
    {
        double near = curve.ParameterAt(from);
        double far = curve.ParameterAt(to);
        return
        [
            Ground(curve.PointBeside(near, left)),
            Ground(curve.PointBeside(near, right)),
            Ground(curve.PointBeside(far, right)),
            Ground(curve.PointBeside(far, left)),
        ];
    }

    /// <summary>The edges of what is driven on, metres to the right of the line: one strip, or one on either side of a median.</summary>
    private IEnumerable<(double Left, double Right)> StripsAt(int link, double station)
    {
        RoadLink road = _network.Links[link];
        (double left, double right) = EdgesOf(link);
        double median = (road.IsOneWay ? 0 : road.MedianWidth ?? 0) / 2;
        return 2 * median < NarrowestIsland || _junctions.Contains(link, station) ? [(left, right)] : [(left, -median), (median, right)];
    }

    private (double Left, double Right) EdgesOf(int link)
    {
        double? right = OuterEdge(link, isForward: true);
        double? left = OuterEdge(link, isForward: false);
        RoadLink road = _network.Links[link];
        bool isHighway = (_network.Nodes[road.From].Flags & _network.Nodes[road.To].Flags & RoadNodeFlags.Highway) != 0;
        double shoulder = isHighway ? HardShoulder : Edge;
        return (-(left ?? right!.Value) - shoulder, (right ?? left!.Value) + shoulder);
    }

    /// <summary>Distance of the right edge of a direction from the line, metres; null without lanes in that direction.</summary>
    private double? OuterEdge(int link, bool isForward) => _lanes.RightEdgeOf(link, isForward);

    /// <summary>A round plate where roads meet, and in a junction the ground between the ends of its roads.</summary>
    private IEnumerable<Vector2D[]> AtNode(int node)
    {
        int[] arms = [.. _network.LinksOf(node).Where(link => RoadContinuations.IsDrivable(_network, _network.Links[link]))];
        if (arms.Length < 2)
        {
            yield break;
        }

        Vector2D centre = Ground(_network.Nodes[node].Position);
        double radius = arms.Min(arm => Math.Min(-EdgesOf(arm).Left, EdgesOf(arm).Right));
        yield return
        [
            .. Enumerable
                .Range(0, PlateSides)
                .Select(side => Math.SinCos(2 * Math.PI * side / PlateSides))
                .Select(angle => centre + (new Vector2D(angle.Cos, angle.Sin) * radius)),
        ];
        if (JunctionExtents.IsJunction(_network, node))
        {
            yield return [.. arms.SelectMany(arm => EndOf(node, arm)).OrderBy(point => Bearing(point - centre))];
        }
    }

    /// <summary>The two edges of a road where its lanes begin.</summary>
    private IEnumerable<Vector2D> EndOf(int node, int link)
    {
        RoadCurve curve = _curves.Of(link);
        (double fromStart, double fromEnd) = _junctions.Of(link);
        double station = _network.Links[link].From == node ? fromStart : curve.Length - fromEnd;
        (double left, double right) = EdgesOf(link);
        return ((double[])[left, right]).Select(offset => Ground(curve.PointBeside(curve.ParameterAt(station), offset)));
    }

    private static double Bearing(Vector2D direction) => Math.Atan2(direction.Y, direction.X);

    private static Vector2D Ground(Vector3D point) => new(point.X, point.Y);
}
