using System;

namespace Harvester.Simulation.Rendering;

/// <summary>A mesh's triangles in the order of the tree over them.</summary>
internal sealed class MeshTree
{
    private const int LeafSize = 4;

    public MeshTree(MeshTriangle[] triangles)
    {
        Hierarchy = new BoundingVolumeHierarchy(Array.ConvertAll(triangles, triangle => Bounds.Of(triangle)), LeafSize);
        Triangles = Array.ConvertAll(Hierarchy.Order, number => triangles[number]);
    }

    public BoundingVolumeHierarchy Hierarchy { get; }

    public MeshTriangle[] Triangles { get; }
}
