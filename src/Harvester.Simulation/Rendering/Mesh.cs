using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A shape of coloured triangles in a model's frame (x right, y forward, z up, metres). It never changes and may be shown by many instances.</summary>
public sealed class Mesh
{
    private readonly MeshTriangle[] _triangles;

    /// <summary>Makes a mesh and the tree that rays and culling find its triangles by; triangles are kept in the tree's order.</summary>
    public Mesh(IEnumerable<MeshTriangle> triangles)
    {
        MeshTriangle[] given = triangles.ToArray();
        Hierarchy = new BoundingVolumeHierarchy(Array.ConvertAll(given, triangle => Rendering.Bounds.Of(triangle)));
        _triangles = Array.ConvertAll(Hierarchy.Order, number => given[number]);
    }

    /// <summary>The triangles.</summary>
    public ReadOnlySpan<MeshTriangle> Triangles => _triangles;

    /// <summary>Least coordinates of all corners, metres.</summary>
    public Vector3D Min => Hierarchy.Bounds.Min;

    /// <summary>Greatest coordinates of all corners, metres.</summary>
    public Vector3D Max => Hierarchy.Bounds.Max;

    internal BoundingVolumeHierarchy Hierarchy { get; }

    internal Bounds Bounds => Hierarchy.Bounds;
}
