using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A triangle of a mesh, seen from both sides.</summary>
/// <param name="A">First corner in the model's frame, metres.</param>
/// <param name="B">Second corner.</param>
/// <param name="C">Third corner.</param>
/// <param name="Colour">Its colour in white light.</param>
/// <param name="Surface">How it reflects or emits light.</param>
public readonly record struct MeshTriangle(Vector3D A, Vector3D B, Vector3D C, Rgb Colour, Surface Surface)
{
    /// <summary>Where it lies across its road; only asphalt has it.</summary>
    public LaneOffsets Lanes { get; init; }
}
