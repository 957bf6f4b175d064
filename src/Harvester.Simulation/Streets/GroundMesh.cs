using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>
/// Collects faces of the ground in world coordinates and returns them as square patches, so that a view need not process all of them;
/// road markings have patches of their own.
/// </summary>
internal sealed class GroundMesh
{
    private const double PatchSize = 80;
    private const double MarkingPatchSize = 40;

    private readonly SortedDictionary<(int X, int Y, bool IsMarking), List<MeshTriangle>> _patches = [];

    public void AddQuad(Vector3D a, Vector3D b, Vector3D c, Vector3D d, Rgb colour, Surface surface)
    {
        AddTriangle(a, b, c, colour, surface);
        AddTriangle(a, c, d, colour, surface);
    }

    /// <summary>Adds asphalt from a left to a right offset across its road.</summary>
    /// <param name="facet">The asphalt.</param>
    /// <param name="left">Offset of its left side, in lanes.</param>
    /// <param name="right">The same of its right side.</param>
    public void AddAsphalt(RoadFacet facet, LaneOffsets left, LaneOffsets right)
    {
        AddTriangle(new MeshTriangle(facet.NearLeft, facet.NearRight, facet.FarRight, Palette.Asphalt, Surface.Asphalt)
        {
            Lanes = left with { B = right.A, C = right.A },
        });
        AddTriangle(new MeshTriangle(facet.NearLeft, facet.FarRight, facet.FarLeft, Palette.Asphalt, Surface.Asphalt)
        {
            Lanes = left with { B = right.A },
        });
    }

    public void AddTriangle(Vector3D a, Vector3D b, Vector3D c, Rgb colour, Surface surface) =>
        AddTriangle(new MeshTriangle(a, b, c, colour, surface));

    private void AddTriangle(in MeshTriangle triangle)
    {
        (Vector3D a, Surface surface) = (triangle.A, triangle.Surface);
        bool isMarking = surface == Surface.Marking;
        double size = isMarking ? MarkingPatchSize : PatchSize;
        (int X, int Y, bool IsMarking) key = ((int)Math.Floor(a.X / size), (int)Math.Floor(a.Y / size), isMarking);
        if (!_patches.TryGetValue(key, out List<MeshTriangle>? patch))
        {
            _patches[key] = patch = [];
        }

        patch.Add(triangle);
    }

    public IEnumerable<MeshInstance> Instances() =>
        _patches.Values.Select(patch => new MeshInstance(new Mesh(patch), new Pose(Vector3D.Zero, Axes.Identity), 0));
}
