using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Surveys;

/// <summary>Rays that pass through entities that no picture shows: a game hides them from pictures, and rays still hit them.</summary>
/// <param name="rays">The game's rays.</param>
/// <param name="isHidden">Whether an entity, by its handle, is hidden now.</param>
public sealed class RaysThroughHidden(ISurfaceRays rays, Func<int, bool> isHidden) : ISurfaceRays
{
    /// <summary>Hidden entities on one ray that it passes: a lorry with its trailer, driver and load, and as many beside them.</summary>
    private const int MaxPassed = 8;

    /// <summary>The next part of a ray begins so far before the entity that is passed, metres: something may touch its surface.</summary>
    private const double StepBack = 0.01;

    /// <inheritdoc/>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => Cast(ray, maxDistance, ignoredEntity, out _);

    /// <inheritdoc/>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity, out Vector3D normal)
    {
        double passed = 0;
        for (int entities = 0; ; entities++)
        {
            var rest = new Ray(ray.Origin + (ray.Direction * passed), ray.Direction);
            RayHit? hit = rays.Cast(rest, maxDistance - passed, ignoredEntity, out normal);
            if (hit is not { } met)
            {
                return null;
            }

            if (met.Entity == RayHit.World || !isHidden(met.Entity) || entities == MaxPassed)
            {
                return met with { Distance = passed + met.Distance };
            }

            // The next part ignores the entity that was met; the one that was ignored before lies behind its origin, or is hidden too.
            passed += Math.Max(0, met.Distance - StepBack);
            ignoredEntity = met.Entity;
        }
    }
}
