using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Ports;

/// <summary>Rays that also report how the surface lies that they hit.</summary>
public interface ISurfaceRays : IRayCaster
{
    /// <summary>Casts a ray like <see cref="IRayCaster.Cast"/>.</summary>
    /// <param name="ray">The ray, in the world.</param>
    /// <param name="maxDistance">Maximum distance, metres; greater than 0.</param>
    /// <param name="ignoredEntity">Handle of one entity that the ray passes through.</param>
    /// <param name="normal">Unit normal of the surface, world, to either side; zero without a hit.</param>
    /// <returns>The hit, or null if there is none within the distance.</returns>
    RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity, out Vector3D normal);
}
