using System.Globalization;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>Names of roads, lanes and junctions, from the numbers of nodes in the road data.</summary>
internal sealed class MapNames
{
    private readonly RoadNetwork _network;
    private readonly Dictionary<int, int> _repeated = [];

    /// <summary>Numbers the roads that have the same nodes.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="links">The links that have lanes outside junctions, ascending.</param>
    public MapNames(RoadNetwork network, IEnumerable<int> links)
    {
        _network = network;
        var counts = new Dictionary<string, int>(StringComparer.Ordinal);
        foreach (int link in links)
        {
            string name = NameOf(network.Links[link]);
            int count = counts.TryGetValue(name, out int before) ? before + 1 : 1;
            counts[name] = count;
            if (count > 1)
            {
                _repeated.Add(link, count);
            }
        }
    }

    /// <summary>The name of a link: those of its nodes, and a number if several links connect them.</summary>
    public string Segment(int link)
    {
        string name = NameOf(_network.Links[link]);
        return _repeated.TryGetValue(link, out int count) ? FormattableString.Invariant($"{name}.{count}") : name;
    }

    public string Junction(int node) => "j" + Node(node);

    public static string Lane(string segment, bool isForward, int index) =>
        FormattableString.Invariant($"{segment}/{(isForward ? 'f' : 'b')}{index}");

    /// <summary>The name of the lanes of one direction of a road, by one of them.</summary>
    public static string Side(MapLane lane) => lane.Id.Substring(0, lane.Id.LastIndexOf('/') + 2);

    /// <summary>A name by a place, to a decimetre.</summary>
    public static string Place(string kind, Vector3D place) =>
        FormattableString.Invariant($"{kind}:{place.X + 0.0:0.0},{place.Y + 0.0:0.0},{place.Z + 0.0:0.0}");

    private string NameOf(RoadLink link) => $"{Node(link.From)}-{Node(link.To)}";

    private string Node(int index)
    {
        RoadNode node = _network.Nodes[index];
        return node.Area == RoadNode.NoArea
            ? index.ToString(CultureInfo.InvariantCulture)
            : FormattableString.Invariant($"{node.Area}:{node.Number}");
    }
}
