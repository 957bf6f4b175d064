using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Visibility;

/// <summary>
/// Estimates visibility by rays through pixels spread evenly over the cuboid's silhouette in the image. A sample counts if its ray hits the
/// object itself; it is hidden if something lies in front of the cuboid. Whether a hidden sample would have hit the object is decided by a
/// second ray that starts at the cuboid, so that the gaps between a cuboid and the object in it do not count. If no sample sees the
/// object, second rays are cast only until one hits it: it is then hidden completely. If no sample is on the object, more rays are cast: it
/// may be thin, outside the image, or not hit by rays.
/// </summary>
public sealed class OcclusionEstimator
{
    /// <summary>
    /// Factor on the number of samples. Masts with an arm fill a twentieth of their cuboid's silhouette: four times the usual 64 rays all
    /// miss them once in 500,000 times.
    /// </summary>
    private const int MoreSamples = 4;

    /// <summary>Number of rays after which an estimate pauses: about a quarter of a millisecond where rays are slowest.</summary>
    public const int RaysOfAStep = 4;

    private readonly int _samples;

    /// <summary>Creates an estimator that takes a number of samples per object.</summary>
    /// <param name="samples">Number of pixels of the silhouette to sample; at least 1. The standard error is about 0.5 / √samples at
    /// worst.</param>
    /// <exception cref="ArgumentOutOfRangeException">Fewer than 1 sample.</exception>
    public OcclusionEstimator(int samples = 64) => _samples = Guard.AtLeast(samples, 1, nameof(samples));

    /// <summary>Maximum number of rays that one estimate takes.</summary>
    public int MaxRays => (2 * MoreSamples * _samples) + SightFinder.Probes;

    /// <summary>Estimates how much of an entity is hidden.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The entity's cuboid.</param>
    /// <param name="projection">The cuboid's projection by the same camera.</param>
    /// <param name="entity">The entity's handle.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing, such as the car that carries the camera; <see
    /// cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster.</param>
    /// <returns>
    /// The estimate; method <see cref="OcclusionMethod.None"/> if nothing of the object is in the image (it is then unseen), or if rays do
    /// not hit it.
    /// </returns>
    public OcclusionEstimate Estimate(
        Camera camera,
        Cuboid cuboid,
        CuboidProjection projection,
        int entity,
        int ignoredEntity,
        IRayCaster rays
    )
    {
        OcclusionEstimate estimate = default;
        foreach (OcclusionEstimate? step in EstimateInSteps(camera, cuboid, projection, entity, ignoredEntity, rays))
        {
            estimate = step ?? default;
        }

        return estimate;
    }

    /// <summary>Estimates as <see cref="Estimate"/> does, a few rays at a time.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The entity's cuboid.</param>
    /// <param name="projection">The cuboid's projection by the same camera.</param>
    /// <param name="entity">The entity's handle.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing; <see cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster.</param>
    /// <returns>Null after each <see cref="RaysOfAStep"/> rays; the estimate at the end.</returns>
    public IEnumerable<OcclusionEstimate?> EstimateInSteps(
        Camera camera,
        Cuboid cuboid,
        CuboidProjection projection,
        int entity,
        int ignoredEntity,
        IRayCaster rays
    )
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(cuboid, nameof(cuboid));
        Guard.NotNull(projection, nameof(projection));
        Guard.NotNull(rays, nameof(rays));
        return Steps(camera, cuboid, projection, entity, ignoredEntity, rays);
    }

    private IEnumerable<OcclusionEstimate?> Steps(
        Camera camera,
        Cuboid cuboid,
        CuboidProjection projection,
        int entity,
        int ignoredEntity,
        IRayCaster rays
    )
    {
        if (projection.Box is not { } box)
        {
            yield return new OcclusionEstimate(0, 0, 0, OcclusionMethod.None) { Sight = Sight.Unseen };
            yield break;
        }

        var probe = new CuboidProbe(camera.Pose.Position, cuboid, entity, ignoredEntity, rays);
        var unexamined = new Queue<Ray>();
        int cast = 0;
        int visible = 0;
        int hidden = 0;
        int onCuboid = 0;
        int stopped = 0;
        foreach (Vector2D pixel in SilhouetteSamples.Of(projection, box, MoreSamples * _samples))
        {
            // Without a sample that sees the object, the fraction is 1 as soon as one hidden sample is on it.
            while (onCuboid >= _samples && visible + hidden == 0 && stopped < onCuboid && unexamined.Count > 0)
            {
                Examine();
                if (IsStepOver())
                {
                    yield return null;
                }
            }

            if (onCuboid >= _samples && (visible + hidden > 0 || stopped == onCuboid))
            {
                break;
            }

            Ray ray = camera.RayThrough(pixel.X, pixel.Y);
            if (cuboid.Intersect(ray) is not { } span)
            {
                continue;
            }

            onCuboid++;
            cast++;

            // A ray that ends behind the cuboid meets the object, something in front of the cuboid, something else inside it, or nothing.
            // Only the second kind is hidden for certain, and may or may not be on the object.
            RayHit? first = rays.Cast(ray, span.Exit + CuboidProbe.Margin, ignoredEntity);
            if (first is { } hit && hit.Entity == entity)
            {
                visible++;
            }
            else if (first is { } blocker && blocker.Distance < span.Entry)
            {
                stopped++;
                unexamined.Enqueue(ray);
            }

            if (IsStepOver())
            {
                yield return null;
            }
        }

        // How many hidden samples are on the object counts only beside samples that see it.
        while (unexamined.Count > 0 && (visible > 0 || hidden == 0))
        {
            Examine();
            if (IsStepOver())
            {
                yield return null;
            }
        }

        int onObject = visible + hidden;
        if (onObject > 0)
        {
            // fraction = hidden / (visible + hidden), over the samples that are on the object.
            yield return new OcclusionEstimate((double)hidden / onObject, onObject, cast, OcclusionMethod.Rays)
            {
                Sight = visible > 0 ? Sight.Seen : Sight.Unseen,
            };
        }
        else if (onCuboid == 0)
        {
            yield return new OcclusionEstimate(0, 0, 0, OcclusionMethod.None) { Sight = Sight.Unseen };
        }
        else if (stopped == onCuboid)
        {
            // Nothing is visible at all, and second rays met nothing: the object is hidden as far as its cuboid shows.
            yield return new OcclusionEstimate(1, onCuboid, cast, OcclusionMethod.CuboidRays) { Sight = Sight.Unseen };
        }
        else
        {
            // Rays pass through the cuboid without meeting the object: is it elsewhere in the cuboid, or do rays not meet it at all?
            Sight? sight = null;
            foreach (Sight? found in SightFinder.FindUnhit(probe))
            {
                cast++;
                sight = found;
                if (sight is null && IsStepOver())
                {
                    yield return null;
                }
            }

            yield return new OcclusionEstimate(0, 0, cast, OcclusionMethod.None) { Sight = sight!.Value };
        }

        void Examine()
        {
            cast++;
            hidden += probe.Meets(unexamined.Dequeue()) ? 1 : 0;
        }

        bool IsStepOver() => cast % RaysOfAStep == 0;
    }
}
