using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A mesh placed in the world.</summary>
/// <param name="Mesh">The shape.</param>
/// <param name="Pose">Position and orientation of the model's frame in the world.</param>
/// <param name="Handle">The entity's handle; 0 for ground, buildings and trees, which are no entities.</param>
public readonly record struct MeshInstance(Mesh Mesh, Pose Pose, int Handle);
