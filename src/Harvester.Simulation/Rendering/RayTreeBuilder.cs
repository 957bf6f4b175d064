namespace Harvester.Simulation.Rendering;

/// <summary>Makes the nodes of a <see cref="RayTree"/>.</summary>
internal sealed class RayTreeBuilder(BoundingVolumeHierarchy hierarchy)
{
    private readonly List<RayNode> _nodes = [];
    private readonly List<(int First, int Count)> _leaves = [];

    /// <returns>The nodes, the root first, and the leaves; both are empty if the hierarchy has no items.</returns>
    public (RayNode[] Nodes, (int First, int Count)[] Leaves) Build()
    {
        if (hierarchy.Order.Length > 0)
        {
            Add(0);
        }

        return (_nodes.ToArray(), _leaves.ToArray());
    }

    private int Add(int root)
    {
        Span<int> chosen = stackalloc int[RayNode.Width];
        int count = Choose(root, chosen);
        Span<Bounds> boxes = stackalloc Bounds[RayNode.Width];
        Span<int> children = stackalloc int[RayNode.Width];
        int own = _nodes.Count;
        _nodes.Add(default);
        for (int i = 0; i < count; i++)
        {
            ref readonly HierarchyNode node = ref hierarchy.Nodes[chosen[i]];
            boxes[i] = node.Bounds;
            children[i] = node.IsLeaf ? ~AddLeaf(node) : Add(chosen[i]);
        }

        _nodes[own] = new RayNode(boxes[..count], children[..count]);
        return own;
    }

    /// <summary>Chooses the children of a node: the greatest box is replaced by the two in it, as long as there is room.</summary>
    private int Choose(int root, Span<int> chosen)
    {
        chosen[0] = root;
        int count = 1;
        while (count < RayNode.Width)
        {
            int greatest = -1;
            for (int i = 0; i < count; i++)
            {
                ref readonly HierarchyNode node = ref hierarchy.Nodes[chosen[i]];
                if (!node.IsLeaf && (greatest < 0 || node.Bounds.HalfArea > hierarchy.Nodes[chosen[greatest]].Bounds.HalfArea))
                {
                    greatest = i;
                }
            }

            if (greatest < 0)
            {
                break;
            }

            // The greatest box is the likeliest to be hit, so opening it saves the most tests of a node of its own.
            int child = hierarchy.Nodes[chosen[greatest]].Child;
            chosen[greatest] = child;
            chosen[count++] = child + 1;
        }

        return count;
    }

    private int AddLeaf(in HierarchyNode node)
    {
        _leaves.Add((node.First, node.Count));
        return _leaves.Count - 1;
    }
}
