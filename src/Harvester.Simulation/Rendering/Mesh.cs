using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A shape of coloured triangles in a model's frame (x right, y forward, z up, metres). It is immutable and may be shared by many
/// instances.
/// </summary>
public sealed class Mesh
{
    private readonly MeshTriangle[] _given;
    private MeshTree? _tree;

    /// <summary>Creates a mesh. The tree for rays and culling is built on first use: much of a world is never seen.</summary>
    public Mesh(IEnumerable<MeshTriangle> triangles)
    {
        _given = triangles.ToArray();
        Bounds bounds = Bounds.Empty;
        foreach (ref readonly MeshTriangle triangle in _given.AsSpan())
        {
            bounds = bounds.With(triangle.A).With(triangle.B).With(triangle.C);
        }

        Bounds = bounds;
        IsMarking = Array.TrueForAll(_given, triangle => triangle.Surface == Surface.Marking);
    }

    /// <summary>The triangles, in the order of the tree.</summary>
    public ReadOnlySpan<MeshTriangle> Triangles => Tree.Triangles;

    /// <summary>Minimum coordinates of all corners, metres.</summary>
    public Vector3D Min => Bounds.Min;

    /// <summary>Maximum coordinates of all corners, metres.</summary>
    public Vector3D Max => Bounds.Max;

    /// <summary>What its surface is.</summary>
    public SurfaceKind Kind { get; init; }

    /// <summary>Whether it casts shadows and takes light of the sky.</summary>
    public bool CastsShadows { get; init; } = true;

    internal Bounds Bounds { get; }

    /// <summary>Whether it consists of road markings.</summary>
    internal bool IsMarking { get; }

    /// <summary>The triangles in the order in which they were given; no tree is built for it.</summary>
    internal ReadOnlySpan<MeshTriangle> Given => _given;

    /// <summary>The triangles and the trees over them. Two threads that ask at once may both build them; the results are equal.</summary>
    internal MeshTree Tree => _tree ??= new MeshTree(_given);
}
