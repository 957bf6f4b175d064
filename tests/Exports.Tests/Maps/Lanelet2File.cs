using System.Globalization;
using System.Xml.Linq;

namespace Harvester.Exports.Tests.Maps;

/// <summary>Reads a Lanelet2 file by the format's own definitions.</summary>
internal sealed class Lanelet2File
{
    private const double EarthRadius = 6378137;

    public Lanelet2File(string text)
    {
        XElement root = XDocument.Parse(text).Root!;
        Elements = [.. root.Elements()];
        Nodes = root.Elements("node").ToDictionary(Id);
        Ways = root.Elements("way").ToDictionary(Id);
        Relations = root.Elements("relation").ToDictionary(Id);
        Lanelets =
        [
            .. Relations.Values.Where(relation => Tag(relation, "type") == "lanelet").Select(relation => new Lanelet2Lane(this, relation)),
        ];
    }

    public IReadOnlyList<XElement> Elements { get; }

    public IReadOnlyDictionary<long, XElement> Nodes { get; }

    public IReadOnlyDictionary<long, XElement> Ways { get; }

    public IReadOnlyDictionary<long, XElement> Relations { get; }

    public IReadOnlyList<Lanelet2Lane> Lanelets { get; }

    public IEnumerable<XElement> Rules => Relations.Values.Where(relation => Tag(relation, "type") == "regulatory_element");

    public static long Id(XElement element) => long.Parse(element.Attribute("id")!.Value, CultureInfo.InvariantCulture);

    public static string? Tag(XElement element, string key) =>
        element.Elements("tag").SingleOrDefault(tag => tag.Attribute("k")!.Value == key)?.Attribute("v")!.Value;

    public static long[] Members(XElement relation, string role) =>
        [.. relation.Elements("member").Where(member => member.Attribute("role")!.Value == role).Select(Ref)];

    public static long Ref(XElement element) => long.Parse(element.Attribute("ref")!.Value, CultureInfo.InvariantCulture);

    public long[] NodesOf(long way) => [.. Ways[way].Elements("nd").Select(Ref)];

    /// <summary>Metres, by the inverse of the spherical Mercator projection about latitude and longitude 0.</summary>
    public (double X, double Y) Place(long node)
    {
        double latitude = Number(Nodes[node].Attribute("lat")!.Value) * Math.PI / 180;
        double longitude = Number(Nodes[node].Attribute("lon")!.Value) * Math.PI / 180;
        return (EarthRadius * longitude, EarthRadius * Math.Log(Math.Tan((Math.PI / 4) + (latitude / 2))));
    }

    public static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
