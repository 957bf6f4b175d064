using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Visibility;

/// <summary>
/// Finds out with few rays whether anything of an object is seen, without an estimate of how much. Rays through its silhouette are cast
/// until one meets it, or until the first few were all stopped before its cuboid. When none meets it though some pass the things in front,
/// rays that start at the cuboid tell an object that is hidden from one that rays do not meet at all.
/// </summary>
public static class SightFinder
{
    /// <summary>
    /// Of an object that is half hidden, one ray in three meets something: all of so many are stopped before it once in 25 times.
    /// </summary>
    private const int StoppedRays = 8;

    /// <summary>Masts with an arm fill a twentieth of their cuboid's silhouette: all of so many rays miss them once in 700 times.</summary>
    private const int MaxSamples = 128;

    /// <summary>Rays that start at the cuboid, before the object counts as one that rays do not meet.</summary>
    internal const int Probes = 64;

    /// <summary>The greatest number of rays that one look may take.</summary>
    public const int MaxRays = MaxSamples + Probes;

    /// <summary>Looks at an entity.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The entity's cuboid.</param>
    /// <param name="projection">The cuboid's image by the same camera.</param>
    /// <param name="entity">The entity's handle.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing, as the car that carries the camera; <see cref="RayHit.World"/>
    /// for none.</param>
    /// <param name="rays">What rays meet.</param>
    /// <returns>The finding; unseen also when nothing of the cuboid is in the image.</returns>
    public static Sight Find(Camera camera, Cuboid cuboid, CuboidProjection projection, int entity, int ignoredEntity, IRayCaster rays)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(cuboid, nameof(cuboid));
        Guard.NotNull(projection, nameof(projection));
        Guard.NotNull(rays, nameof(rays));
        if (projection.Box is not { } box)
        {
            return Sight.Unseen;
        }

        int asked = 0;
        bool allStopped = true;
        foreach (Vector2D pixel in SilhouetteSamples.Of(projection, box, MaxSamples))
        {
            Ray ray = camera.RayThrough(pixel.X, pixel.Y);
            if (cuboid.Intersect(ray) is not { } span)
            {
                continue;
            }

            RayHit? first = rays.Cast(ray, span.Exit + CuboidProbe.Margin, ignoredEntity);
            if (first is { } hit && hit.Entity == entity)
            {
                return Sight.Seen;
            }

            asked++;
            allStopped &= first is { } blocker && blocker.Distance < span.Entry;
            if (allStopped && asked == StoppedRays)
            {
                break;
            }
        }

        return allStopped ? Sight.Unseen : FindUnhit(new CuboidProbe(camera.Pose.Position, cuboid, entity, ignoredEntity, rays), out _);
    }

    /// <summary>
    /// Tells an object that is not seen from one that rays do not meet, by rays all over its cuboid, in the image or not.
    /// </summary>
    /// <param name="probe">The object's probe.</param>
    /// <param name="cast">The number of rays cast.</param>
    /// <returns>Unseen or undetermined.</returns>
    internal static Sight FindUnhit(CuboidProbe probe, out int cast)
    {
        cast = 0;
        foreach (Ray ray in probe.Through(Probes))
        {
            cast++;
            if (probe.Meets(ray))
            {
                return Sight.Unseen;
            }
        }

        return Sight.Undetermined;
    }
}
