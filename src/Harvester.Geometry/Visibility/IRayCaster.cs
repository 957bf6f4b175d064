namespace Harvester.Geometry.Visibility;

/// <summary>
/// The port through which visibility and pixel maps ask a world what a ray meets. Answers must not depend on the order of the
/// questions as long as the world stands still. Implementers let their exceptions through; the harvest handles them.
/// </summary>
public interface IRayCaster
{
    /// <summary>The first thing that a ray meets.</summary>
    /// <param name="ray">The ray, in the world.</param>
    /// <param name="maxDistance">How far to look, metres; greater than 0.</param>
    /// <param name="ignoredEntity">Handle of one entity that the ray passes through; <see cref="RayHit.World"/> for none.</param>
    /// <returns>The hit, or null when there is none within the distance.</returns>
    RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity);
}
