using System.Globalization;
using System.Xml.Linq;
using Harvester.Geometry;

namespace Harvester.Exports.Tests.Maps;

/// <summary>A driving lane of an OpenDRIVE file, read by the format's own definitions.</summary>
internal sealed class OpenDriveLane(XElement road, XElement lane)
{
    public string RoadId => road.Attribute("id")!.Value;

    public int Id => (int)Number(lane, "id");

    public string Name => lane.Element("userData")!.Attribute("value")!.Value;

    /// <summary>The line at its outer edge; null if the file has none.</summary>
    public XElement? Mark => lane.Element("roadMark");

    /// <summary>The middle at a part of the road's length, from its start.</summary>
    public Vector3D MiddleAt(double fraction)
    {
        double s = fraction * Number(road, "length");
        (double x, double y, double heading) = OpenDriveLine.At(road, fraction);
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

    private static double Width(XElement lane, double s) => Polynomial(lane.Elements("width"), s, "sOffset");

    public static double Polynomial(IEnumerable<XElement> pieces, double s, string station = "s")
    {
        XElement piece = pieces.Last(each => Number(each, station) <= s);
        double ds = s - Number(piece, station);
        return Number(piece, "a") + (ds * (Number(piece, "b") + (ds * (Number(piece, "c") + (ds * Number(piece, "d"))))));
    }

    public static double Number(XElement element, string name) =>
        double.Parse(element.Attribute(name)!.Value, CultureInfo.InvariantCulture);
}
