namespace Harvester.Simulation.Rendering;

/// <summary>
/// A node: the box around items [First, First + Count) of the order; a leaf has no child, others have two at Child and Child + 1.
/// </summary>
internal readonly record struct HierarchyNode(Bounds Bounds, int First, int Count, int Child)
{
    public bool IsLeaf => Child == 0;
}
