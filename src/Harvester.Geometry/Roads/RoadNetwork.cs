namespace Harvester.Geometry.Roads;

/// <summary>Roads as nodes and the links between them. Immutable.</summary>
public sealed class RoadNetwork
{
    private readonly int[][] _linksOfNode;

    /// <summary>Creates a network of nodes, links and reported edges.</summary>
    /// <param name="nodes">The nodes.</param>
    /// <param name="links">The links between them.</param>
    /// <param name="edges">The reported points on edges of the links; null if there are none.</param>
    /// <exception cref="ArgumentException">
    /// A link refers to a node that does not exist, or has the same node at both ends; or an edge refers to a link that does not exist.
    /// </exception>
    public RoadNetwork(IReadOnlyList<RoadNode> nodes, IReadOnlyList<RoadLink> links, IReadOnlyList<RoadEdge>? edges = null)
    {
        Nodes = Guard.NotNull(nodes, nameof(nodes));
        Links = Guard.NotNull(links, nameof(links));
        Edges = edges ?? [];
        var linksOfNode = new List<int>[nodes.Count];
        for (int i = 0; i < links.Count; i++)
        {
            RoadLink link = links[i];
            if (link.From < 0 || link.From >= nodes.Count || link.To < 0 || link.To >= nodes.Count || link.From == link.To)
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"Link {i} runs from node {link.From} to node {link.To}; there are {nodes.Count} nodes."),
                    nameof(links)
                );
            }

            (linksOfNode[link.From] ??= []).Add(i);
            (linksOfNode[link.To] ??= []).Add(i);
        }

        foreach (RoadEdge edge in Edges)
        {
            if (edge.Link < 0 || edge.Link >= links.Count)
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"An edge is one of link {edge.Link}; there are {links.Count} links."),
                    nameof(edges)
                );
            }
        }

        _linksOfNode = Array.ConvertAll(linksOfNode, list => list?.ToArray() ?? []);
    }

    /// <summary>The nodes; a link refers to them by their index in this list.</summary>
    public IReadOnlyList<RoadNode> Nodes { get; }

    /// <summary>The links, each once.</summary>
    public IReadOnlyList<RoadLink> Links { get; }

    /// <summary>The reported points on edges of the links, in no order; empty if there are none.</summary>
    public IReadOnlyList<RoadEdge> Edges { get; }

    /// <summary>The indices of the links that start or end at a node.</summary>
    public IReadOnlyList<int> LinksOf(int node) => _linksOfNode[node];
}
