using System;

namespace Harvester.Simulation.Rendering;

/// <summary>Some of an instance's triangles: those numbered [First, First + Count).</summary>
internal readonly record struct MeshPiece(MeshInstance Instance, int First, int Count)
{
    public ReadOnlySpan<MeshTriangle> Triangles => Instance.Mesh.Triangles.Slice(First, Count);
}
