using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Simulation.Streets;

/// <summary>A chain of links with one layout.</summary>
/// <param name="Nodes">Numbers of the nodes along it, at least two; a one-way road runs forward.</param>
/// <param name="Layout">Its lanes, as seen along it.</param>
internal sealed record RoadChain(IReadOnlyList<int> Nodes, LaneLayout Layout)
{
    /// <summary>Cuts a set of links into chains that end where roads meet, where the layout changes, at corners and at dead ends.</summary>
    public static List<RoadChain> Follow(RoadNetwork network, IReadOnlyList<RoadLink> links)
    {
        ILookup<int, RoadLink> linksOf = links
            .SelectMany(link => new[] { (Node: link.From, link), (Node: link.To, link) })
            .ToLookup(pair => pair.Node, pair => pair.link);
        List<RoadChain> chains = [];
        HashSet<RoadLink> used = new(ReferenceEqualityComparer.Instance);
        foreach (RoadLink link in links)
        {
            if (used.Add(link))
            {
                LaneLayout layout = LaneLayout.Of(link);
                LinkedList<int> nodes = new([link.From, link.To]);
                Extend(nodes, layout, forward: true);
                Extend(nodes, layout, forward: false);
                chains.Add(layout.Forward > 0 ? new RoadChain([.. nodes], layout) : new RoadChain([.. nodes.Reverse()], layout.Reversed()));
            }
        }

        return chains;

        void Extend(LinkedList<int> nodes, LaneLayout layout, bool forward)
        {
            while (true)
            {
                int end = forward ? nodes.Last!.Value : nodes.First!.Value;
                RoadLink? next = linksOf[end].FirstOrDefault(link => !used.Contains(link));
                if (next is null)
                {
                    return;
                }

                int other = next.From == end ? next.To : next.From;
                int before = forward ? nodes.Last!.Previous!.Value : nodes.First!.Next!.Value;
                if (
                    linksOf[end].Count() != 2
                    || LayoutFrom(next, end, forward) != layout
                    || KindOf(end) != KindOf(other)
                    || IsCorner(network, before, end, other, layout.HalfWidth)
                )
                {
                    return;
                }

                used.Add(next);
                _ = forward ? nodes.AddLast(other) : nodes.AddFirst(other);
            }
        }

        RoadNodeFlags KindOf(int node) =>
            network.Nodes[node].Flags & (RoadNodeFlags.Highway | RoadNodeFlags.OffRoad | RoadNodeFlags.Tunnel);
    }

    /// <summary>
    /// Directions at the nodes where one chain continues another: at a change of layout, and across a junction for the two arms that are
    /// straightest to each other. The key is the node and the next node of the chain; the direction points along it.
    /// </summary>
    public static Dictionary<(int Node, int Neighbour), Vector3D> EndTangents(RoadNetwork network, IReadOnlyList<RoadChain> chains)
    {
        ILookup<int, (int Next, double HalfWidth)> neighbours = chains
            .SelectMany(chain =>
                new[]
                {
                    (End: chain.Nodes[0], Next: chain.Nodes[1], chain.Layout),
                    (End: chain.Nodes[^1], Next: chain.Nodes[^2], chain.Layout),
                }
            )
            .ToLookup(end => end.End, end => (end.Next, end.Layout.HalfWidth));
        Dictionary<(int Node, int Neighbour), Vector3D> tangents = [];
        foreach (IGrouping<int, (int Next, double HalfWidth)> node in neighbours)
        {
            List<(int Next, double HalfWidth)> open = [.. node];
            while (StraightestPair(network, node.Key, open) is { } pair)
            {
                Vector3D before = network.Nodes[node.Key].Position - network.Nodes[pair.A.Next].Position;
                Vector3D after = network.Nodes[pair.B.Next].Position - network.Nodes[node.Key].Position;
                Vector3D through = ((before / before.LengthSquared) + (after / after.LengthSquared)).Normalized();
                tangents[(node.Key, pair.B.Next)] = through;
                tangents[(node.Key, pair.A.Next)] = -through;
                open.Remove(pair.A);
                open.Remove(pair.B);
            }
        }

        return tangents;
    }

    private static ((int Next, double HalfWidth) A, (int Next, double HalfWidth) B)? StraightestPair(
        RoadNetwork network,
        int node,
        List<(int Next, double HalfWidth)> open
    )
    {
        const double straightAtMost = 0.7;
        ((int, double), (int, double))? best = null;
        double bestTurn = open.Count == 2 ? Math.PI / 2 : straightAtMost;
        for (int i = 0; i < open.Count; i++)
        {
            for (int j = i + 1; j < open.Count; j++)
            {
                double turn = TurnAt(network, open[i].Next, node, open[j].Next);
                if (
                    turn < bestTurn
                    && open[i].Next != open[j].Next
                    && !IsCorner(network, open[i].Next, node, open[j].Next, Math.Max(open[i].HalfWidth, open[j].HalfWidth))
                )
                {
                    bestTurn = turn;
                    best = (open[i], open[j]);
                }
            }
        }

        return best;
    }

    /// <summary>Whether the road turns so sharply at a node that a smooth line through it would fold the lanes on its inner side.</summary>
    private static bool IsCorner(RoadNetwork network, int before, int node, int after, double halfWidth)
    {
        // The arc that touches both pieces, as large as the shorter one allows; the curve through the nodes is sharper in places.
        const double room = 1.6;
        Vector3D corner = network.Nodes[node].Position;
        double shorter = Math.Min(
            Horizontal.Distance(network.Nodes[before].Position, corner),
            Horizontal.Distance(network.Nodes[after].Position, corner)
        );
        return shorter / (2 * Math.Tan(TurnAt(network, before, node, after) / 2)) < room * halfWidth;
    }

    private static double TurnAt(RoadNetwork network, int before, int node, int after)
    {
        Vector3D corner = network.Nodes[node].Position;
        return Math.Abs(Horizontal.Turn(corner - network.Nodes[before].Position, network.Nodes[after].Position - corner));
    }

    private static LaneLayout LayoutFrom(RoadLink link, int node, bool forward)
    {
        LaneLayout layout = LaneLayout.Of(link);
        return link.From == node == forward ? layout : layout.Reversed();
    }
}
