namespace Harvester.Geometry.Visibility;

/// <summary>
/// The port through which visibility and pixel maps find out what a ray hits. Results must not depend on the order of the calls while the
/// world stands still. Implementations do not catch exceptions; the harvest handles them.
/// </summary>
public interface IRayCaster
{
    /// <summary>Finds the first thing that a ray hits.</summary>
    /// <param name="ray">The ray, in the world.</param>
    /// <param name="maxDistance">Maximum distance, metres; greater than 0.</param>
    /// <param name="ignoredEntity">Handle of one entity that the ray passes through; <see cref="RayHit.World"/> if there is none.</param>
    /// <returns>The hit, or null if there is none within the distance.</returns>
    RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity);
}
