using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;

namespace Harvester.Geometry.Visibility;

/// <summary>
/// Finds out with few rays whether any of an object is visible, without estimating how much. Rays through its silhouette are cast until one
/// hits it, or until the first few were all stopped in front of its cuboid. If none hits it although some pass the things in front, rays
/// that start at the cuboid distinguish a hidden object from one that rays do not hit at all.
/// </summary>
public static class SightFinder
{
    /// <summary>
    /// For a half hidden object, one ray in three hits it: this many in a row are all stopped in front of it once in 25 times, (2/3)^8.
    /// </summary>
    private const int StoppedRays = 8;

    /// <summary>Minimum number of rays stopped by one thing: three points of the world are always on a plane.</summary>
    private const int StoppedByOneThing = 4;

    /// <summary>Maximum number of pixels of the silhouette for each ray stopped by one thing: half of what is plainly there.</summary>
    private const double PixelsOfARay = 32;

    /// <summary>
    /// Masts with an arm fill a twentieth of their cuboid's silhouette: this many rays all miss them once in 700 times, 0.95^128.
    /// </summary>
    private const int MaxSamples = 128;

    /// <summary>Number of rays that start at the cuboid before the object counts as not hit by rays.</summary>
    internal const int Probes = 64;

    /// <summary>Maximum number of rays per object.</summary>
    public const int MaxRays = MaxSamples + Probes;

    /// <summary>Finds out whether any of an entity is visible.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The entity's cuboid.</param>
    /// <param name="projection">The cuboid's projection by the same camera.</param>
    /// <param name="entity">The entity's handle.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing, such as the car that carries the camera; <see
    /// cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster.</param>
    /// <returns>The finding; unseen also if nothing of the cuboid is in the image.</returns>
    public static Sight Find(Camera camera, Cuboid cuboid, CuboidProjection projection, int entity, int ignoredEntity, IRayCaster rays)
    {
        var found = new WorkResult<Sight>();
        WorkRun.Complete(FindInSteps(camera, cuboid, projection, entity, ignoredEntity, rays, found));
        return found.Value;
    }

    /// <summary>Examines an entity as <see cref="Find"/> does, a few rays at a time.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The entity's cuboid.</param>
    /// <param name="projection">The cuboid's projection by the same camera.</param>
    /// <param name="entity">The entity's handle.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing; <see cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster.</param>
    /// <param name="found">Receives the finding.</param>
    /// <returns>The steps: a pause after each <see cref="OcclusionEstimator.RaysOfAStep"/> rays.</returns>
    public static IEnumerable<WorkStep> FindInSteps(
        Camera camera,
        Cuboid cuboid,
        CuboidProjection projection,
        int entity,
        int ignoredEntity,
        IRayCaster rays,
        WorkResult<Sight> found
    )
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(cuboid, nameof(cuboid));
        Guard.NotNull(projection, nameof(projection));
        Guard.NotNull(rays, nameof(rays));
        Guard.NotNull(found, nameof(found));
        return Steps(camera, cuboid, projection, entity, ignoredEntity, rays, found);
    }

    private static IEnumerable<WorkStep> Steps(
        Camera camera,
        Cuboid cuboid,
        CuboidProjection projection,
        int entity,
        int ignoredEntity,
        IRayCaster rays,
        WorkResult<Sight> found
    )
    {
        if (projection.Box is not { } box)
        {
            found.Value = Sight.Unseen;
            yield break;
        }

        int asked = 0;
        bool allStopped = true;
        var stoppers = new List<SurfacePoint>();
        double enough = Math.Max(StoppedByOneThing, SilhouetteSamples.AreaOf(projection) / PixelsOfARay);
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
                found.Value = Sight.Seen;
                yield break;
            }

            asked++;
            if (first is { } blocker && blocker.Distance < span.Entry)
            {
                stoppers.Add(SurfacePoint.Of(ray, blocker));
            }

            allStopped = stoppers.Count == asked;
            if (allStopped && (asked == StoppedRays || (asked >= enough && SurfacePoint.AreOnOneThing(stoppers))))
            {
                break;
            }

            if (asked % OcclusionEstimator.RaysOfAStep == 0)
            {
                yield return WorkStep.Pause;
            }
        }

        if (allStopped)
        {
            found.Value = Sight.Unseen;
            yield break;
        }

        var unhit = new WorkResult<(Sight Sight, int Cast)>();
        yield return WorkStep.Do(FindUnhit(new CuboidProbe(camera.Pose.Position, cuboid, entity, ignoredEntity, rays), asked, unhit));
        found.Value = unhit.Value.Sight;
    }

    /// <summary>
    /// Distinguishes an unseen object from one that rays do not hit, by rays all over its cuboid, inside and outside the image.
    /// </summary>
    /// <param name="probe">The object's probe.</param>
    /// <param name="cast">Number of rays cast for the object before.</param>
    /// <param name="found">Receives unseen or undetermined, and the number of all rays cast for the object.</param>
    internal static IEnumerable<WorkStep> FindUnhit(CuboidProbe probe, int cast, WorkResult<(Sight Sight, int Cast)> found)
    {
        int left = Probes;
        foreach (Ray ray in probe.Through(Probes))
        {
            cast++;
            left--;
            bool isHit = probe.Meets(ray);
            if (isHit || left == 0)
            {
                found.Value = (isHit ? Sight.Unseen : Sight.Undetermined, cast);
                yield break;
            }

            if (cast % OcclusionEstimator.RaysOfAStep == 0)
            {
                yield return WorkStep.Pause;
            }
        }
    }
}
