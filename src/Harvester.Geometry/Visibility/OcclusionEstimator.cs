using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;

namespace Harvester.Geometry.Visibility;

/// <summary>
/// Estimates visibility by samples at pixels spread evenly over the cuboid's silhouette in the image. A sample counts if its ray hits the
/// object itself; it is hidden if something lies in front of the object. Whether a hidden sample would have hit the object is decided by a
/// second ray that starts at the cuboid, so that the gaps between a cuboid and the object in it do not count.
/// </summary>
/// <remarks>
/// Rays are spent where they decide something. The first samples are cast. If they see the object and nothing hides it, that is the result.
/// A further sample is cast only where the samples around it disagree; elsewhere their answer is its answer, and so it is with second rays.
/// If something lies in front of every sample, the object is hidden completely, without second rays. If few samples of an object that is
/// partly hidden are on it, or none at all, more follow: it may be thin, outside the image, or not hit by rays.
/// </remarks>
public sealed class OcclusionEstimator
{
    /// <summary>Number of rays after which an estimate pauses: about a quarter of a millisecond where rays are slowest.</summary>
    public const int RaysOfAStep = 4;

    /// <summary>
    /// Factor on the number of samples. Masts with an arm fill a twentieth of their cuboid's silhouette: four times the usual 64 rays all
    /// miss them once in 500,000 times.
    /// </summary>
    private const int MoreSamples = 4;

    /// <summary>An object is hardly seen until this part of the number of samples is on it: a sixteenth, 4 of 64.</summary>
    private const int HardlySeen = 16;

    /// <summary>A part of an object of this many pixels is plainly there.</summary>
    private const double PlainPixels = 64;

    /// <summary>
    /// Number of samples cast in the area of such a part before an object may count as hidden.
    /// </summary>
    private const int SamplesOfAPlainPart = 4;

    private readonly int _samples;
    private readonly int _all;
    private readonly int _first;
    private readonly int _firstOfOverlapped;
    private readonly int _enoughOnObject;

    /// <summary>Creates an estimator. Of the numbers below, those of the usual 64 samples were chosen on simulated streets.</summary>
    /// <param name="samples">Number of pixels of the silhouette to sample; at least 1. The standard error is about 0.5 / √samples at
    /// worst.</param>
    /// <exception cref="ArgumentOutOfRangeException">Fewer than 1 sample.</exception>
    public OcclusionEstimator(int samples = 64)
    {
        _samples = Guard.AtLeast(samples, 1, nameof(samples));

        // Most samples are inferred: an eighth more make up for those that are inferred wrongly. 72 for 64.
        _all = samples + (samples / 8);

        // 12 for 64, and 24 where something is known to be in front.
        _first = Math.Min(_all, Math.Max(NearestSamples<bool>.Count, samples * 3 / 16));
        _firstOfOverlapped = Math.Min(_all, Math.Max(NearestSamples<bool>.Count, samples * 6 / 16));

        // 16 for 64: a car has them at once, a mast seldom.
        _enoughOnObject = samples / 4;
    }

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
    /// <param name="isOverlapped">Whether something nearer is known to overlap it in the image; more samples are then cast before it
    /// counts as unhidden.</param>
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
        IRayCaster rays,
        bool isOverlapped = true
    )
    {
        var estimate = new WorkResult<OcclusionEstimate>();
        WorkRun.Complete(EstimateInSteps(camera, cuboid, projection, entity, ignoredEntity, rays, estimate, isOverlapped));
        return estimate.Value;
    }

    /// <summary>Estimates as <see cref="Estimate"/> does, a few rays at a time.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The entity's cuboid.</param>
    /// <param name="projection">The cuboid's projection by the same camera.</param>
    /// <param name="entity">The entity's handle.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing; <see cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster.</param>
    /// <param name="estimate">Receives the estimate.</param>
    /// <param name="isOverlapped">Whether something nearer is known to overlap it in the image.</param>
    /// <returns>The steps: a pause after each <see cref="RaysOfAStep"/> rays.</returns>
    public IEnumerable<WorkStep> EstimateInSteps(
        Camera camera,
        Cuboid cuboid,
        CuboidProjection projection,
        int entity,
        int ignoredEntity,
        IRayCaster rays,
        WorkResult<OcclusionEstimate> estimate,
        bool isOverlapped = true
    )
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(cuboid, nameof(cuboid));
        Guard.NotNull(projection, nameof(projection));
        Guard.NotNull(rays, nameof(rays));
        Guard.NotNull(estimate, nameof(estimate));
        return Steps(camera, cuboid, projection, entity, ignoredEntity, rays, estimate, isOverlapped);
    }

    private IEnumerable<WorkStep> Steps(
        Camera camera,
        Cuboid cuboid,
        CuboidProjection projection,
        int entity,
        int ignoredEntity,
        IRayCaster rays,
        WorkResult<OcclusionEstimate> estimate,
        bool isOverlapped
    )
    {
        if (projection.Box is not { } box)
        {
            estimate.Value = new OcclusionEstimate(0, 0, 0, OcclusionMethod.None) { Sight = Sight.Unseen };
            yield break;
        }

        var probe = new CuboidProbe(camera.Pose.Position, cuboid, entity, ignoredEntity, rays);
        var known = new SampleNeighbours(box);
        var unexamined = new Queue<(Ray Ray, Vector2D Pixel)>();
        int first = isOverlapped ? _firstOfOverlapped : _first;
        double firstOfHidden = Math.Max(
            _first,
            Math.Min(_samples, SamplesOfAPlainPart * SilhouetteSamples.AreaOf(projection) / PlainPixels)
        );
        int cast = 0;
        int visible = 0;
        int hidden = 0;
        int onCuboid = 0;
        int stopped = 0;
        foreach (Vector2D pixel in SilhouetteSamples.Of(projection, box, MoreSamples * _samples))
        {
            // Without a sample that sees the object, the fraction is 1 as soon as one hidden sample is on it.
            while (onCuboid >= _all && visible + hidden == 0 && stopped < onCuboid && unexamined.Count > 0)
            {
                Examine();
                if (IsStepOver())
                {
                    yield return WorkStep.Pause;
                }
            }

            if (IsEnough())
            {
                break;
            }

            Ray ray = camera.RayThrough(pixel.X, pixel.Y);
            if (cuboid.Intersect(ray) is not { } span)
            {
                continue;
            }

            // The samples around one on a thin object are all beside it, so those of an object that is hardly seen are cast.
            SampleFinding? finding = null;
            if (onCuboid >= first && visible >= _samples / HardlySeen)
            {
                finding = known.Infer(pixel);
            }
            else if (onCuboid >= firstOfHidden && stopped == onCuboid && known.IsBehindOneThing(pixel))
            {
                finding = SampleFinding.Stopped;
            }

            onCuboid++;
            if (finding is null)
            {
                cast++;
                RayHit? hit = rays.Cast(ray, span.Exit + CuboidProbe.Margin, ignoredEntity);
                if (IsStepOver())
                {
                    yield return WorkStep.Pause;
                }

                finding = FindingOf(hit, span, entity);
                if (finding == SampleFinding.HiddenInside)
                {
                    cast++;
                    finding = probe.MeetsBehind(ray, hit!.Value.Distance) ? finding : SampleFinding.Gap;
                    if (IsStepOver())
                    {
                        yield return WorkStep.Pause;
                    }
                }

                known.Add(pixel, finding.Value, ray, hit);
            }

            visible += finding == SampleFinding.OnObject ? 1 : 0;
            hidden += finding == SampleFinding.HiddenInside ? 1 : 0;
            if (finding == SampleFinding.Stopped)
            {
                stopped++;
                unexamined.Enqueue((ray, pixel));
            }
        }

        // How many hidden samples are on the object counts only beside samples that see it; whether any is, if some samples pass.
        while (unexamined.Count > 0 && (visible > 0 || (hidden == 0 && stopped < onCuboid)))
        {
            Examine();
            if (IsStepOver())
            {
                yield return WorkStep.Pause;
            }
        }

        // fraction = hidden / (visible + hidden), over the samples that are on the object.
        int onObject = visible + hidden;
        if (onObject > 0)
        {
            estimate.Value = new OcclusionEstimate((double)hidden / onObject, onObject, cast, OcclusionMethod.Rays)
            {
                Sight = visible > 0 ? Sight.Seen : Sight.Unseen,
            };
        }
        else if (onCuboid == 0)
        {
            estimate.Value = new OcclusionEstimate(0, 0, 0, OcclusionMethod.None) { Sight = Sight.Unseen };
        }
        else if (stopped == onCuboid)
        {
            // Nothing is visible at all: the object is hidden as far as its cuboid shows.
            estimate.Value = new OcclusionEstimate(1, onCuboid, cast, OcclusionMethod.CuboidRays) { Sight = Sight.Unseen };
        }
        else
        {
            // Rays pass through the cuboid without meeting the object: is it elsewhere in the cuboid, or do rays not meet it at all?
            var unhit = new WorkResult<(Sight Sight, int Cast)>();
            yield return WorkStep.Do(SightFinder.FindUnhit(probe, cast, unhit));
            estimate.Value = new OcclusionEstimate(0, 0, unhit.Value.Cast, OcclusionMethod.None) { Sight = unhit.Value.Sight };
        }

        bool IsEnough()
        {
            if (onCuboid < first)
            {
                return false;
            }

            if (visible > 0 && stopped + hidden == 0)
            {
                return visible >= _samples / HardlySeen || onCuboid >= _all;
            }

            if (onCuboid < _all || visible == 0)
            {
                return onCuboid >= _all && (hidden > 0 || stopped == onCuboid);
            }

            // Where it is stopped, the object fills its silhouette as elsewhere: v of the n - s other samples are on it, v n / (n - s) of
            // all.
            return visible * onCuboid >= _enoughOnObject * (onCuboid - stopped);
        }

        void Examine()
        {
            (Ray ray, Vector2D pixel) = unexamined.Dequeue();
            bool? isObject = visible > 0 ? known.InferShape(pixel) : null;
            if (isObject is null)
            {
                cast++;
                isObject = probe.Meets(ray);
                known.AddShape(pixel, isObject.Value);
            }

            hidden += isObject.Value ? 1 : 0;
        }

        bool IsStepOver() => cast % RaysOfAStep == 0;
    }

    /// <summary>
    /// What a ray found, as far as it shows by itself: a hit on the world inside the cuboid hides the object if that is behind it.
    /// </summary>
    private static SampleFinding FindingOf(RayHit? hit, RaySpan span, int entity) =>
        hit is not { } met ? SampleFinding.Gap
        : met.Entity == entity ? SampleFinding.OnObject
        : met.Distance < span.Entry ? SampleFinding.Stopped
        : met.Entity == RayHit.World && met.Distance + CuboidProbe.Thickness < span.Exit ? SampleFinding.HiddenInside
        : SampleFinding.Gap;
}
