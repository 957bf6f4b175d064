namespace Harvester.Simulation.Rendering;

/// <summary>Builds a hierarchy top down: each set of items is split where the surface area heuristic over a few bins is smallest.</summary>
internal sealed class HierarchyBuilder
{
    private const int BinCount = 12;

    /// <summary>From this depth on, sets are halved, so that no input makes a tree too deep for the traversal stacks.</summary>
    private const int DepthOfHalving = 64;

    private readonly IReadOnlyList<Bounds> _items;
    private readonly int[] _order;
    private readonly List<HierarchyNode> _nodes = [];
    private readonly List<int> _depths = [];
    private readonly Bounds[] _binBounds = new Bounds[BinCount];
    private readonly int[] _binCounts = new int[BinCount];
    private readonly double[] _costFromRight = new double[BinCount];

    private readonly int _leafSize;

    public HierarchyBuilder(IReadOnlyList<Bounds> items, int leafSize)
    {
        _leafSize = leafSize;
        _items = items;
        _order = new int[items.Count];
        for (int i = 0; i < _order.Length; i++)
        {
            _order[i] = i;
        }
    }

    public (HierarchyNode[] Nodes, int[] Order) Build()
    {
        Add(0, _order.Length, 0);
        for (int next = 0; next < _nodes.Count; next++)
        {
            Split(next);
        }

        return (_nodes.ToArray(), _order);
    }

    private void Split(int number)
    {
        HierarchyNode node = _nodes[number];
        if (node.Count <= _leafSize)
        {
            return;
        }

        int leftCount = _depths[number] < DepthOfHalving ? PartByBins(node) : 0;
        leftCount = leftCount > 0 && leftCount < node.Count ? leftCount : node.Count / 2;
        int middle = node.First + leftCount;
        _nodes[number] = node with { Child = _nodes.Count };
        Add(node.First, leftCount, _depths[number] + 1);
        Add(middle, node.Count - leftCount, _depths[number] + 1);
    }

    private void Add(int first, int count, int depth)
    {
        _nodes.Add(new HierarchyNode(BoundsOf(first, count), first, count, 0));
        _depths.Add(depth);
    }

    /// <summary>
    /// Partitions a node's items at the best plane along the longest side of the box of their centres; returns how many lie left of it.
    /// </summary>
    private int PartByBins(HierarchyNode node)
    {
        Bounds centres = Bounds.Empty;
        for (int i = node.First; i < node.First + node.Count; i++)
        {
            centres = centres.With(_items[_order[i]].Centre);
        }

        (int axis, double low, double length) = LongestSide(centres);
        if (!(length > 0))
        {
            return 0;
        }

        double scale = BinCount / length;
        int Bin(int item) => Math.Min(BinCount - 1, (int)((Component(_items[item].Centre, axis) - low) * scale));
        int split = BestSplit(node, Bin);
        int left = node.First;
        for (int i = node.First; i < node.First + node.Count; i++)
        {
            if (Bin(_order[i]) < split)
            {
                (_order[left], _order[i]) = (_order[i], _order[left]);
                left++;
            }
        }

        return left - node.First;
    }

    private int BestSplit(HierarchyNode node, Func<int, int> bin)
    {
        // The items and their box, bin by bin.
        Array.Fill(_binBounds, Bounds.Empty);
        Array.Clear(_binCounts);
        for (int i = node.First; i < node.First + node.Count; i++)
        {
            int own = bin(_order[i]);
            _binBounds[own] = _binBounds[own].With(_items[_order[i]]);
            _binCounts[own]++;
        }

        // Area times count of everything from each bin on, swept from the right.
        Bounds right = Bounds.Empty;
        int rightCount = 0;
        for (int i = BinCount - 1; i > 0; i--)
        {
            right = right.With(_binBounds[i]);
            rightCount += _binCounts[i];
            _costFromRight[i] = right.HalfArea * rightCount;
        }

        int best = 1;
        double bestCost = double.PositiveInfinity;
        Bounds left = Bounds.Empty;
        int leftCount = 0;
        for (int i = 1; i < BinCount; i++)
        {
            left = left.With(_binBounds[i - 1]);
            leftCount += _binCounts[i - 1];

            // Surface area heuristic: a ray that meets the node meets a part with a probability in proportion to its area, and tests its
            // items then: A_left n_left + A_right n_right.
            double cost = (left.HalfArea * leftCount) + _costFromRight[i];
            if (cost < bestCost && leftCount > 0 && leftCount < node.Count)
            {
                (best, bestCost) = (i, cost);
            }
        }

        return best;
    }

    private Bounds BoundsOf(int first, int count)
    {
        Bounds bounds = Bounds.Empty;
        for (int i = first; i < first + count; i++)
        {
            bounds = bounds.With(_items[_order[i]]);
        }

        return bounds;
    }

    private static (int Axis, double Low, double Length) LongestSide(Bounds bounds)
    {
        Geometry.Vector3D size = bounds.Max - bounds.Min;
        int axis = size.X >= size.Y ? (size.X >= size.Z ? 0 : 2) : (size.Y >= size.Z ? 1 : 2);
        return (axis, Component(bounds.Min, axis), Component(size, axis));
    }

    private static double Component(Geometry.Vector3D vector, int axis) =>
        axis == 0 ? vector.X
        : axis == 1 ? vector.Y
        : vector.Z;
}
