using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Scenes;

namespace ToyGame;

/// <summary>Casts rays at the boxes of entities and at the ground, z = 0.</summary>
internal sealed class BoxRays(Func<IReadOnlyList<EntityState>> entities) : IRayCaster
{
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        RayHit? nearest = GroundAlong(ray) is { } ground ? new RayHit(ground, RayHit.World) : null;
        foreach (EntityState entity in entities())
        {
            if (
                entity.Handle != ignoredEntity
                && BoxAlong(ray, entity) is { } distance
                && distance < (nearest?.Distance ?? double.PositiveInfinity)
            )
            {
                nearest = new RayHit(distance, entity.Handle);
            }
        }

        return nearest is { } hit && hit.Distance <= maxDistance ? hit : null;
    }

    // origin.z + t direction.z = 0
    private static double? GroundAlong(Ray ray) => ray.Direction.Z < 0 ? -ray.Origin.Z / ray.Direction.Z : null;

    // Slabs: in the frame of the model, the ray is within the box where it is between both faces along every axis.
    private static double? BoxAlong(Ray ray, EntityState entity)
    {
        Vector3D origin = entity.Pose.ToLocal(ray.Origin);
        Vector3D direction = entity.Pose.Axes.ToLocal(ray.Direction);
        double enter = 0;
        double leave = double.PositiveInfinity;
        foreach (
            (double o, double d, double min, double max) in new[]
            {
                (origin.X, direction.X, entity.ModelMin.X, entity.ModelMax.X),
                (origin.Y, direction.Y, entity.ModelMin.Y, entity.ModelMax.Y),
                (origin.Z, direction.Z, entity.ModelMin.Z, entity.ModelMax.Z),
            }
        )
        {
            double a = (min - o) / d;
            double b = (max - o) / d;
            enter = Math.Max(enter, Math.Min(a, b));
            leave = Math.Min(leave, Math.Max(a, b));
        }

        return enter <= leave ? enter : null;
    }
}
