using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A tree of boxes over items, for rays and for view culling. An item is identified by its index in <see cref="Order"/>.</summary>
internal sealed class BoundingVolumeHierarchy
{
    /// <summary>Nodes that may wait while the tree is walked, at most.</summary>
    public const int MaxTreeDepth = 128;

    private readonly HierarchyNode[] _nodes;
    private readonly Slabs[] _slabs;

    /// <param name="items">The items' boxes.</param>
    /// <param name="leafSize">Items that a leaf may hold.</param>
    public BoundingVolumeHierarchy(IReadOnlyList<Bounds> items, int leafSize)
    {
        (_nodes, Order) = new HierarchyBuilder(items, leafSize).Build();
        _slabs = Array.ConvertAll(_nodes, node => new Slabs(node.Bounds));
    }

    /// <summary>The items' numbers in the order of the leaves.</summary>
    public int[] Order { get; }

    /// <summary>The box around all items; empty if there are none.</summary>
    public Bounds Bounds => _nodes[0].Bounds;

    /// <summary>Visits the leaves that a ray passes through before the limit, nearer children first.</summary>
    [SkipLocalsInit]
    public void Visit<TVisitor>(Vector3D origin, Vector3D direction, ref double limit, ref TVisitor visitor)
        where TVisitor : struct, ILeafVisitor
    {
        Vector256<double> start = Slabs.Origin(origin);
        Vector256<double> inverse = Slabs.Inverse(direction);
        Span<int> stack = stackalloc int[MaxTreeDepth];
        Span<double> entries = stackalloc double[MaxTreeDepth];
        int depth = 0;
        double rootEntry = _slabs[0].Entry(start, inverse, limit);
        if (Order.Length > 0 && rootEntry <= limit)
        {
            (stack[0], entries[0], depth) = (0, rootEntry, 1);
        }

        while (depth > 0)
        {
            depth--;
            if (entries[depth] > limit)
            {
                continue;
            }

            ref readonly HierarchyNode node = ref _nodes[stack[depth]];
            if (node.IsLeaf)
            {
                visitor.Visit(node.First, node.Count, ref limit);
                continue;
            }

            double left = _slabs[node.Child].Entry(start, inverse, limit);
            double right = _slabs[node.Child + 1].Entry(start, inverse, limit);
            int nearer = left <= right ? node.Child : node.Child + 1;
            int farther = left <= right ? node.Child + 1 : node.Child;
            double far = Math.Max(left, right);
            double near = Math.Min(left, right);
            if (far <= limit)
            {
                (stack[depth], entries[depth]) = (farther, far);
                depth++;
            }

            if (near <= limit)
            {
                (stack[depth], entries[depth]) = (nearer, near);
                depth++;
            }
        }
    }

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
