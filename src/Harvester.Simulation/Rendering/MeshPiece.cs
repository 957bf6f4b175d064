namespace Harvester.Simulation.Rendering;

/// <summary>Some of an instance's triangles: those numbered [First, First + Count).</summary>
internal readonly record struct MeshPiece(MeshInstance Instance, int First, int Count);
