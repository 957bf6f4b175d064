using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Rays as a face sees them: what is hit of its own model elsewhere than in the face's cuboid is a thing of the world like any other,
/// so a post before the face or the plate's own back hides it. The plate around the head of a light belongs to the head.
/// </summary>
/// <param name="rays">What rays meet.</param>
/// <param name="parent">Handle of the entity that bears the face.</param>
/// <param name="cuboid">The face's cuboid.</param>
/// <param name="margin">How far outside the cuboid a hit is still on the face, along right, forward and up of the model, metres.</param>
internal sealed class FaceRays(IRayCaster rays, int parent, Cuboid cuboid, Vector3D margin) : IRayCaster
{
    private readonly Cuboid _face = new(cuboid.Centre, cuboid.HalfExtents + margin, cuboid.Axes);

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        RayHit? first = rays.Cast(ray, maxDistance, ignoredEntity);
        return first is { } hit && hit.Entity == parent && !_face.Contains(ray.At(hit.Distance))
            ? hit with { Entity = RayHit.World }
            : first;
    }
}
