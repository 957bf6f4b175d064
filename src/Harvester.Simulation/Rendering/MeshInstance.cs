using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A mesh somewhere in the world.</summary>
/// <param name="Mesh">The shape.</param>
/// <param name="Pose">Where the model's origin is and how it is turned.</param>
/// <param name="Handle">The entity's handle; 0 for the world itself: ground, buildings, trees.</param>
public readonly record struct MeshInstance(Mesh Mesh, Pose Pose, int Handle);
