namespace Harvester.Simulation.Rendering;

/// <summary>A mesh's triangles in the order of the tree over them, and the tree for rays.</summary>
internal sealed class MeshTree
{
    public MeshTree(MeshTriangle[] triangles)
    {
        Hierarchy = new BoundingVolumeHierarchy(Array.ConvertAll(triangles, triangle => Bounds.Of(triangle)), TriangleBlock.Width);
        Triangles = Array.ConvertAll(Hierarchy.Order, number => triangles[number]);
        Rays = new RayTree(Hierarchy);
        Blocks = Array.ConvertAll(Rays.Leaves, leaf => new TriangleBlock(Triangles.AsSpan(leaf.First, leaf.Count)));
    }

    public BoundingVolumeHierarchy Hierarchy { get; }

    public MeshTriangle[] Triangles { get; }

    /// <summary>The tree for rays.</summary>
    public RayTree Rays { get; }

    /// <summary>The triangles of each leaf of the tree for rays.</summary>
    public TriangleBlock[] Blocks { get; }
}
