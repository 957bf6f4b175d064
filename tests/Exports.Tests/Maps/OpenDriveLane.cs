using System.Globalization;
using System.Xml.Linq;
using Harvester.Geometry;

namespace Harvester.Exports.Tests.Maps;

/// <summary>A driving lane of an OpenDRIVE file, read by the format's own definitions.</summary>
internal sealed class OpenDriveLane(XElement road, XElement lane)
{
    private const int LengthPieces = 400;

    public string RoadId => road.Attribute("id")!.Value;

    public int Id => (int)Number(lane, "id");

    public string Name => lane.Element("userData")!.Attribute("value")!.Value;

    /// <summary>The middle at a part of the road's length, from its start.</summary>
    public Vector3D MiddleAt(double fraction)
    {
        double s = fraction * Number(road, "length");
        (double x, double y, double heading) = LineAt(fraction);
        double t = Polynomial(road.Element("lanes")!.Elements("laneOffset"), s) + Aside(s);
        return new Vector3D(
            x - (Math.Sin(heading) * t),
            y + (Math.Cos(heading) * t),
            Polynomial(road.Element("elevationProfile")!.Elements("elevation"), s)
        );
    }

    /// <summary>The lanes that follow in the direction of travel: on the right, lanes run with the road's line.</summary>
    public IEnumerable<(string Road, int Lane)> Next(ILookup<string, XElement> connectionsFrom)
    {
        string end = Id < 0 ? "successor" : "predecessor";
        XElement? next = road.Element("link")!.Element(end);
        return next is null ? []
            : next.Attribute("elementType")!.Value == "junction"
                ? connectionsFrom[RoadId]
                    .Where(connection => connection.Parent!.Attribute("id")!.Value == next.Attribute("elementId")!.Value)
                    .Where(connection => Number(connection.Element("laneLink")!, "from") == Id)
                    .Select(connection =>
                        (connection.Attribute("connectingRoad")!.Value, (int)Number(connection.Element("laneLink")!, "to"))
                    )
            : lane.Element("link")?.Element(end) is { } linked ? [(next.Attribute("elementId")!.Value, (int)Number(linked, "id"))]
            : [];
    }

    /// <summary>Offset of the middle to the left of lane 0: half of its width and that of the lanes between.</summary>
    private double Aside(double s)
    {
        double aside = Width(lane, s) / 2;
        foreach (XElement other in lane.Parent!.Elements("lane"))
        {
            aside += Math.Abs(Number(other, "id")) < Math.Abs(Id) ? Width(other, s) : 0;
        }

        return Id > 0 ? aside : -aside;
    }

    private (double X, double Y, double Heading) LineAt(double fraction)
    {
        XElement geometry = road.Element("planView")!.Elements("geometry").Single();
        XElement curve = geometry.Element("paramPoly3")!;
        Assert.Equal("normalized", curve.Attribute("pRange")!.Value);

        // The parameter at a length, by a table of the length so far.
        double[] lengths = new double[LengthPieces + 1];
        for (int i = 1; i <= LengthPieces; i++)
        {
            (double du, double dv) = Derivative(curve, (i - 0.5) / LengthPieces);
            lengths[i] = lengths[i - 1] + (Math.Sqrt((du * du) + (dv * dv)) / LengthPieces);
        }

        double wanted = fraction * lengths[^1];
        int piece = Math.Clamp(Array.FindIndex(lengths, length => length >= wanted), 1, LengthPieces);
        double p = (piece - 1 + ((wanted - lengths[piece - 1]) / (lengths[piece] - lengths[piece - 1]))) / LengthPieces;
        (double u, double v) = (Value(curve, "U", p), Value(curve, "V", p));
        (double uSlope, double vSlope) = Derivative(curve, p);
        double start = Number(geometry, "hdg");
        return (
            Number(geometry, "x") + (Math.Cos(start) * u) - (Math.Sin(start) * v),
            Number(geometry, "y") + (Math.Sin(start) * u) + (Math.Cos(start) * v),
            start + Math.Atan2(vSlope, uSlope)
        );
    }

    private static double Value(XElement curve, string axis, double p) =>
        Number(curve, "a" + axis) + (p * (Number(curve, "b" + axis) + (p * (Number(curve, "c" + axis) + (p * Number(curve, "d" + axis))))));

    private static (double U, double V) Derivative(XElement curve, double p)
    {
        double Slope(string axis) =>
            Number(curve, "b" + axis) + (p * ((2 * Number(curve, "c" + axis)) + (3 * p * Number(curve, "d" + axis))));
        return (Slope("U"), Slope("V"));
    }

    private static double Width(XElement lane, double s) => Polynomial(lane.Elements("width"), s, "sOffset");

    private static double Polynomial(IEnumerable<XElement> pieces, double s, string station = "s")
    {
        XElement piece = pieces.Last(each => Number(each, station) <= s);
        double ds = s - Number(piece, station);
        return Number(piece, "a") + (ds * (Number(piece, "b") + (ds * (Number(piece, "c") + (ds * Number(piece, "d"))))));
    }

    private static double Number(XElement element, string name) =>
        double.Parse(element.Attribute(name)!.Value, CultureInfo.InvariantCulture);
}
