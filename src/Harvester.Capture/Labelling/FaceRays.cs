using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Rays as they count for a face: a hit on its own model outside the face's cuboid counts as a hit on the world, so a post in front of the
/// face or the back of the plate hides it. The backplate around the head of a light belongs to the head.
/// </summary>
/// <param name="rays">The ray caster.</param>
/// <param name="parent">Handle of the entity that has the face.</param>
/// <param name="cuboid">The face's cuboid.</param>
/// <param name="margin">Maximum distance outside the cuboid at which a hit is still on the face, along right, forward and up of the model,
/// metres.</param>
internal sealed class FaceRays(IRayCaster rays, int parent, Cuboid cuboid, Vector3D margin) : IRayCaster
{
    private readonly Cuboid _face = new(cuboid.Centre, cuboid.HalfExtents + margin, cuboid.Axes);

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        RayHit? first = rays.Cast(ray, maxDistance, ignoredEntity);
        return first is { } hit && hit.Entity == parent && !_face.Contains(ray.At(hit.Distance))
            ? hit with
            {
                Entity = RayHit.World,
            }
            : first;
    }
}
