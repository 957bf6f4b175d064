using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A tree of boxes for rays: the nodes of a <see cref="BoundingVolumeHierarchy"/>, of which each here has up to eight children instead of
/// two.
/// </summary>
internal sealed class RayTree
{
    /// <summary>Maximum number of nodes that may wait while the tree is walked: all but one child of each level.</summary>
    private const int MaxWaiting = (RayNode.Width - 1) * BoundingVolumeHierarchy.MaxTreeDepth;

    private readonly RayNode[] _nodes;

    public RayTree(BoundingVolumeHierarchy hierarchy) => (_nodes, Leaves) = new RayTreeBuilder(hierarchy).Build();

    /// <summary>The leaves, by number: items [First, First + Count) of the hierarchy's order.</summary>
    public (int First, int Count)[] Leaves { get; }

    /// <summary>Visits the leaves whose boxes a ray hits before the limit, nearer children first.</summary>
    [SkipLocalsInit]
    public void Visit<TVisitor>(Vector3D origin, Vector3D direction, ref double limit, ref TVisitor visitor)
        where TVisitor : struct, ILeafVisitor
    {
        if (_nodes.Length == 0)
        {
            return;
        }

        var ray = new PreparedRay(origin, direction);
        float reach = PreparedRay.Reach(limit);
        Span<long> waiting = stackalloc long[MaxWaiting];
        int count = 0;
        long next = 0;
        while (true)
        {
            int child = (int)next;
            if (child < 0)
            {
                visitor.Visit(~child, ref limit);
                reach = PreparedRay.Reach(limit);
            }
            else
            {
                ref readonly RayNode node = ref _nodes[child];
                uint hits = ray.Hits(node, reach, out Vector256<float> entries);
                if (hits != 0)
                {
                    Push(waiting, ref count, hits, entries, node.Children);
                    next = waiting[--count];
                    continue;
                }
            }

            do
            {
                if (count == 0)
                {
                    return;
                }

                next = waiting[--count];
            } while (EntryOf(next) > reach);
        }
    }

    /// <summary>Adds the children that a ray hits, the nearest last.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Push(Span<long> waiting, ref int count, uint hits, Vector256<float> entries, Vector256<int> children)
    {
        // The bits of floating-point numbers of 0 or more have the order of the numbers.
        int others = count;
        for (; hits != 0; hits &= hits - 1)
        {
            int i = BitOperations.TrailingZeroCount(hits);
            long found = ((long)BitConverter.SingleToInt32Bits(entries[i]) << 32) | (uint)children[i];
            int at = count++;
            for (; at > others && waiting[at - 1] < found; at--)
            {
                waiting[at] = waiting[at - 1];
            }

            waiting[at] = found;
        }
    }

    private static float EntryOf(long waiting) => BitConverter.Int32BitsToSingle((int)(waiting >> 32));
}
