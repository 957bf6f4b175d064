using System;
using System.Collections.Generic;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A tree of boxes over items, for rays and for what lies in a camera's view. Items are named by their place in <see cref="Order"/>.</summary>
internal sealed class BoundingVolumeHierarchy
{
    private const int MaxTreeDepth = 128;
    private readonly HierarchyNode[] _nodes;

    public BoundingVolumeHierarchy(IReadOnlyList<Bounds> items) => (_nodes, Order) = new HierarchyBuilder(items).Build();

    /// <summary>The items' numbers in the order of the leaves.</summary>
    public int[] Order { get; }

    /// <summary>The box around everything; empty for no items.</summary>
    public Bounds Bounds => _nodes[0].Bounds;

    /// <summary>Visits the leaves that a ray passes through before the limit, nearer children first.</summary>
    public void Visit<TVisitor>(Vector3D origin, Vector3D direction, ref double limit, ref TVisitor visitor)
        where TVisitor : struct, ILeafVisitor
    {
        var inverse = new Vector3D(Inverse(direction.X), Inverse(direction.Y), Inverse(direction.Z));
        Span<int> stack = stackalloc int[MaxTreeDepth];
        Span<double> entries = stackalloc double[MaxTreeDepth];
        int depth = 0;
        double rootEntry = Entry(_nodes[0].Bounds, origin, inverse, limit);
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

            double left = Entry(_nodes[node.Child].Bounds, origin, inverse, limit);
            double right = Entry(_nodes[node.Child + 1].Bounds, origin, inverse, limit);
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

    /// <summary>Adds the ranges of the order whose boxes are not wholly outside one of the planes; a range may hold items that are.</summary>
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

    /// <summary>A finite stand-in for 1 / 0, so that a ray along a face gives 0 and not a missing number.</summary>
    private static double Inverse(double component) => component == 0 ? 1e300 : 1 / component;

    /// <summary>Where a ray enters a box; infinity when it misses.</summary>
    private static double Entry(in Bounds box, Vector3D origin, Vector3D inverse, double limit)
    {
        double entry = 0;
        double exit = limit;
        Narrow((box.Min.X - origin.X) * inverse.X, (box.Max.X - origin.X) * inverse.X, ref entry, ref exit);
        Narrow((box.Min.Y - origin.Y) * inverse.Y, (box.Max.Y - origin.Y) * inverse.Y, ref entry, ref exit);
        Narrow((box.Min.Z - origin.Z) * inverse.Z, (box.Max.Z - origin.Z) * inverse.Z, ref entry, ref exit);

        // Rounding of the slabs must not lose a hit on a box's very edge.
        const double room = 1 + 1e-12;
        return entry <= exit * room ? entry : double.PositiveInfinity;
    }

    private static void Narrow(double a, double b, ref double entry, ref double exit)
    {
        double near = a < b ? a : b;
        double far = a < b ? b : a;
        entry = near > entry ? near : entry;
        exit = far < exit ? far : exit;
    }
}
