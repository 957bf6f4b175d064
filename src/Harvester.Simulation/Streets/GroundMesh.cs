using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>
/// Collects faces of the ground in world coordinates and returns them as square patches, each of one kind of surface, so that a view need
/// not process all of them.
/// </summary>
internal sealed class GroundMesh
{
    private const double PatchSize = 80;
    private const double MarkingPatchSize = 40;

    private readonly SortedDictionary<(int X, int Y, SurfaceKind Kind), List<MeshTriangle>> _patches = [];

    public void AddQuad(Vector3D a, Vector3D b, Vector3D c, Vector3D d, Rgb colour, Surface surface, SurfaceKind kind)
    {
        AddTriangle(a, b, c, colour, surface, kind);
        AddTriangle(a, c, d, colour, surface, kind);
    }

    /// <summary>Adds asphalt from a left to a right offset across its road.</summary>
    /// <param name="facet">The asphalt.</param>
    /// <param name="left">Offset of its left side, in lanes.</param>
    /// <param name="right">The same of its right side.</param>
    public void AddAsphalt(RoadFacet facet, LaneOffsets left, LaneOffsets right)
    {
        var near = new MeshTriangle(facet.NearLeft, facet.NearRight, facet.FarRight, Palette.Asphalt, Surface.Asphalt)
        {
            Lanes = left with { B = right.A, C = right.A },
        };
        var far = new MeshTriangle(facet.NearLeft, facet.FarRight, facet.FarLeft, Palette.Asphalt, Surface.Asphalt)
        {
            Lanes = left with { B = right.A },
        };
        AddTriangle(near, SurfaceKind.Road);
        AddTriangle(far, SurfaceKind.Road);
    }

    public void AddTriangle(Vector3D a, Vector3D b, Vector3D c, Rgb colour, Surface surface, SurfaceKind kind) =>
        AddTriangle(new MeshTriangle(a, b, c, colour, surface), kind);

    private void AddTriangle(in MeshTriangle triangle, SurfaceKind kind)
    {
        Vector3D a = triangle.A;
        double size = kind == SurfaceKind.Marking ? MarkingPatchSize : PatchSize;
        (int X, int Y, SurfaceKind Kind) key = ((int)Math.Floor(a.X / size), (int)Math.Floor(a.Y / size), kind);
        if (!_patches.TryGetValue(key, out List<MeshTriangle>? patch))
        {
            _patches[key] = patch = [];
        }

        patch.Add(triangle);
    }

    public IEnumerable<MeshInstance> Instances() =>
        _patches.Select(patch => new MeshInstance(
            new Mesh(patch.Value) { Kind = patch.Key.Kind },
            new Pose(Vector3D.Zero, Axes.Identity),
            0
        ));
}
