using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>What a ray has hit.</summary>
/// <param name="Instance">The mesh in the world.</param>
/// <param name="Leaf">The leaf of the mesh's tree with the triangle.</param>
internal readonly record struct SurfaceHit(MeshInstance Instance, int Leaf)
{
    /// <summary>The unit normal of the triangle, to either side, world.</summary>
    /// <param name="ray">The ray that has hit it.</param>
    /// <param name="distance">Where it was hit, metres along the ray.</param>
    public Vector3D NormalOf(Ray ray, double distance) =>
        Instance.Pose.Axes.ToWorld(
            Instance.Mesh.Tree.Blocks[Leaf].NormalAt(Instance.Pose.ToLocal(ray.Origin), Instance.Pose.Axes.ToLocal(ray.Direction), distance)
        );
}
