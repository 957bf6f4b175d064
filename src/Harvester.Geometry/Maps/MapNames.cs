using System.Globalization;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>Names of roads, lanes and junctions, from the numbers of nodes in the road data.</summary>
internal sealed class MapNames(RoadNetwork network)
{
    private readonly Dictionary<string, int> _segments = new(StringComparer.Ordinal);

    /// <summary>The name of a link: those of its nodes, and a number if several links connect them.</summary>
    public string Segment(RoadLink link)
    {
        string name = $"{Node(link.From)}-{Node(link.To)}";
        int count = _segments.TryGetValue(name, out int before) ? before + 1 : 1;
        _segments[name] = count;
        return count == 1 ? name : FormattableString.Invariant($"{name}.{count}");
    }

    public string Junction(int node) => "j" + Node(node);

    public static string Lane(string segment, bool isForward, int index) =>
        FormattableString.Invariant($"{segment}/{(isForward ? 'f' : 'b')}{index}");

    /// <summary>The name of the lanes of one direction of a road, by one of them.</summary>
    public static string Side(MapLane lane) => lane.Id.Substring(0, lane.Id.LastIndexOf('/') + 2);

    /// <summary>A name by a place, to a decimetre.</summary>
    public static string Place(string kind, Vector3D place) =>
        FormattableString.Invariant($"{kind}:{place.X + 0.0:0.0},{place.Y + 0.0:0.0},{place.Z + 0.0:0.0}");

    private string Node(int index)
    {
        RoadNode node = network.Nodes[index];
        return node.Area == RoadNode.NoArea
            ? index.ToString(CultureInfo.InvariantCulture)
            : FormattableString.Invariant($"{node.Area}:{node.Number}");
    }
}
