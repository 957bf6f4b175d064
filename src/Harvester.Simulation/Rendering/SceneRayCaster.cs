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
        SurfaceHit hit = default;
        return Intersect(ray, ignoredEntity, ref limit, ref hit) ? HitOf(limit, hit) : null;
    }

    /// <summary>Casts a ray and finds the normal of the surface that it hits.</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="maxDistance">Maximum distance, metres.</param>
    /// <param name="ignoredEntity">Handle of an entity that the ray passes through.</param>
    /// <param name="normal">Unit normal to either side, world; zero without a hit.</param>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity, out Vector3D normal)
    {
        double limit = maxDistance;
        SurfaceHit hit = default;
        bool isHit = Intersect(ray, ignoredEntity, ref limit, ref hit);
        normal = isHit ? hit.NormalOf(ray, limit) : Vector3D.Zero;
        return isHit ? HitOf(limit, hit) : null;
    }

    private bool Intersect(Ray ray, int ignoredEntity, ref double limit, ref SurfaceHit hit)
    {
        bool isHit = _scene.Static.Intersect(ray, ignoredEntity, ref limit, ref hit);
        return _scene.Dynamic.Intersect(ray, ignoredEntity, ref limit, ref hit) || isHit;
    }

    private static RayHit HitOf(double distance, in SurfaceHit hit) =>
        new(distance, hit.Instance.Handle) { Material = SurfaceMaterial.Of(hit.Instance.Mesh.Kind) };
}
