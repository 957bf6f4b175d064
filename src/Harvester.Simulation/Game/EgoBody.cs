using Harvester.Geometry;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.Game;

/// <summary>The body of the car that carries cameras, which neither pictures nor rays show.</summary>
internal static class EgoBody
{
    private const double ReachMetres = 10;

    /// <summary>Whether a point is inside: the body is above, below, ahead, behind, and on both sides of it.</summary>
    /// <param name="ego">The car.</param>
    /// <param name="point">The point in the frame of the car's model, metres.</param>
    public static bool Encloses(Vehicle ego, Vector3D point)
    {
        Pose pose = ego.Pose;
        var body = new SceneRayCaster(new RenderScene([new MeshInstance(ego.Model.Variant(ego.Handle), pose, ego.Handle)]));
        Vector3D[] sides = [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)];
        return Array.TrueForAll(sides, side => IsHit(side) && IsHit(side * -1));

        bool IsHit(Vector3D side) => body.Cast(new Ray(pose.ToWorld(point), pose.Axes.ToWorld(side)), ReachMetres, 0) is not null;
    }
}
