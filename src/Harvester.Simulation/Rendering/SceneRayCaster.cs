using System;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Simulation.Rendering;

/// <summary>Casts rays against the same shapes that the renderer draws.</summary>
public sealed class SceneRayCaster : IRayCaster
{
    private readonly RenderScene _scene;

    /// <summary>Creates a ray caster that uses the scene as it is at the time of each call.</summary>
    public SceneRayCaster(RenderScene scene)
    {
        ArgumentNullException.ThrowIfNull(scene);
        _scene = scene;
    }

    /// <inheritdoc/>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        double limit = maxDistance;
        int handle = RayHit.World;
        SurfaceKind kind = default;
        bool hit = _scene.Static.Intersect(ray, ignoredEntity, ref limit, ref handle, ref kind);
        hit |= _scene.Dynamic.Intersect(ray, ignoredEntity, ref limit, ref handle, ref kind);
        return hit ? new RayHit(limit, handle) { Material = SurfaceMaterial.Of(kind) } : null;
    }
}
