namespace Harvester.Simulation.Rendering;

/// <summary>
/// A tree of boxes over items, for view culling; a <see cref="RayTree"/> is made of it for rays. An item is identified by its index in
/// <see cref="Order"/>.
/// </summary>
internal sealed class BoundingVolumeHierarchy
{
    /// <summary>Nodes that may wait while the tree is walked, at most.</summary>
    public const int MaxTreeDepth = 128;

    private readonly HierarchyNode[] _nodes;

    /// <param name="items">The items' boxes.</param>
    /// <param name="leafSize">Items that a leaf may hold.</param>
    public BoundingVolumeHierarchy(IReadOnlyList<Bounds> items, int leafSize)
    {
        (_nodes, Order) = new HierarchyBuilder(items, leafSize).Build();
    }

    /// <summary>The items' numbers in the order of the leaves.</summary>
    public int[] Order { get; }

    /// <summary>The box around all items; empty if there are none.</summary>
    public Bounds Bounds => _nodes[0].Bounds;

    /// <summary>
    /// Adds the ranges of the order whose boxes are not wholly outside one of the planes; a range may contain items that are.
    /// </summary>
    public void AddRangesInside(ReadOnlySpan<Plane> planes, List<(int First, int Count)> ranges)
    {
        Span<int> stack = stackalloc int[MaxTreeDepth];
        int depth = 0;
        if (Order.Length > 0)
        {
            stack[depth++] = 0;
        }

        while (depth > 0)
        {
            ref readonly HierarchyNode node = ref _nodes[stack[--depth]];
            bool inside = true;
            bool outside = false;
            foreach (ref readonly Plane plane in planes)
            {
                outside |= plane.IsOutside(node.Bounds);
                inside &= plane.IsInside(node.Bounds);
            }

            if (outside)
            {
                continue;
            }

            if (node.IsLeaf || inside)
            {
                AddRange(ranges, node.First, node.Count);
                continue;
            }

            stack[depth++] = node.Child + 1;
            stack[depth++] = node.Child;
        }
    }

    /// <summary>The nodes: the root first, each with its children further on.</summary>
    public ReadOnlySpan<HierarchyNode> Nodes => _nodes;

    private static void AddRange(List<(int First, int Count)> ranges, int first, int count)
    {
        if (ranges.Count > 0 && ranges[^1].First + ranges[^1].Count == first)
        {
            ranges[^1] = (ranges[^1].First, ranges[^1].Count + count);
        }
        else
        {
            ranges.Add((first, count));
        }
    }
}
