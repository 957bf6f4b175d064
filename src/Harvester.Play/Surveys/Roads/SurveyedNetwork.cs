using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Play.Surveys.Roads;

/// <summary>
/// A growing network. Nodes are identified by their stored positions, which is all that the game's links give of them, and links by the
/// nodes at their ends.
/// </summary>
internal sealed class SurveyedNetwork
{
    private readonly List<RoadNode> _nodes = [];
    private readonly List<RoadLink> _links = [];
    private readonly List<RoadEdge> _edges = [];
    private readonly List<int> _edgesOfLink = [];
    private readonly Dictionary<Vector3D, int> _indices = [];
    private readonly Dictionary<(int Low, int High), int> _linksByEnds = [];

    public int NodeCount => _nodes.Count;

    public int LinkCount => _links.Count;

    public int EdgeCount => _edges.Count;

    /// <summary>Adds the result of an earlier survey. Nodes at one stored position, and links between the same nodes, are merged.</summary>
    public void Add(RoadNetwork earlier)
    {
        var nodes = new List<int>();
        foreach (RoadNode node in earlier.Nodes)
        {
            nodes.Add(Add(node, PathGrid.Truncate(node.Position)));
        }

        var links = new List<int?>();
        foreach (RoadLink link in earlier.Links)
        {
            links.Add(Add(link with { From = nodes[link.From], To = nodes[link.To] }));
        }

        foreach (RoadEdge edge in earlier.Edges)
        {
            // When links are merged, their ends may have been swapped: such edges are not kept.
            if (links[edge.Link] is { } link && _links[link].From == nodes[earlier.Links[edge.Link].From])
            {
                Add(edge with { Link = link });
            }
        }
    }

    public int? Find(Vector3D stored) => _indices.TryGetValue(Key(stored), out int index) ? index : null;

    public RoadNode Node(int node) => _nodes[node];

    public RoadLink Link(int link) => _links[link];

    /// <summary>Number of known points on the edges of a link.</summary>
    public int EdgesOf(int link) => _edgesOfLink[link];

    public int Add(RoadNode node, Vector3D stored)
    {
        if (_indices.TryGetValue(Key(stored), out int known))
        {
            return known;
        }

        _indices.Add(Key(stored), _nodes.Count);
        _nodes.Add(node);
        return _nodes.Count - 1;
    }

    /// <summary>
    /// The index of a link, which is added unless there is one between its nodes; null for a link whose ends are the same node.
    /// </summary>
    public int? Add(RoadLink link)
    {
        if (link.From == link.To)
        {
            return null;
        }

        (int, int) ends = (Math.Min(link.From, link.To), Math.Max(link.From, link.To));
        if (!_linksByEnds.TryGetValue(ends, out int index))
        {
            index = _links.Count;
            _linksByEnds.Add(ends, index);
            _links.Add(link);
            _edgesOfLink.Add(0);
        }

        return index;
    }

    public void Add(RoadEdge edge)
    {
        _edges.Add(edge);
        _edgesOfLink[edge.Link]++;
    }

    public RoadNetwork ToNetwork() => new([.. _nodes], [.. _links], [.. _edges]);

    /// <summary>Without negative zero, whose hash differs from that of zero in some runtimes.</summary>
    private static Vector3D Key(Vector3D stored) => stored + Vector3D.Zero;
}
