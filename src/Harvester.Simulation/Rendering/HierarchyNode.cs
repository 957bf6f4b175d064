namespace Harvester.Simulation.Rendering;

/// <summary>
/// A node: the box around items [First, First + Count) of the order. A leaf has no child; other nodes have two, at Child and Child + 1.
/// </summary>
internal readonly record struct HierarchyNode(Bounds Bounds, int First, int Count, int Child)
{
    public bool IsLeaf => Child == 0;
}
