using System;
using System.Collections.Generic;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Visibility;

/// <summary>
/// Visibility by rays over a deterministic pattern: the points of a fixed low-discrepancy sequence (the R2 sequence, whose steps
/// are the inverse powers of the plastic number) that fall on the cuboid's silhouette in the image. A sample counts where its ray meets the object itself; it is hidden when
/// something lies nearer than the cuboid. Whether a hidden sample would have met the object is asked by a second ray that starts
/// at the cuboid, so that the gaps between a cuboid and the object in it do not count.
/// </summary>
public sealed class OcclusionEstimator
{
    private const double PlasticNumber = 1.32471795724474602596;

    /// <summary>How far outside the cuboid the second ray starts, metres, so that a surface on the cuboid's face is met.</summary>
    private const double EntryMargin = 0.01;

    /// <summary>How many points of the sequence are tried for each that is wanted, before a sliver of a silhouette is given up.</summary>
    private const int TriesPerSample = 16;

    private readonly int _samples;

    /// <summary>Makes an estimator.</summary>
    /// <param name="samples">Points wanted on the silhouette; at least 1. The standard error is about 0.5 / √samples at worst.</param>
    /// <exception cref="ArgumentOutOfRangeException">Fewer than 1 sample.</exception>
    public OcclusionEstimator(int samples = 64)
    {
        if (samples < 1)
        {
            throw new ArgumentOutOfRangeException(nameof(samples), samples, "At least one sample is needed.");
        }

        _samples = samples;
    }

    /// <summary>Estimates how much of an entity is hidden.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The entity's cuboid.</param>
    /// <param name="projection">The cuboid's image by the same camera.</param>
    /// <param name="entity">The entity's handle.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing, as the car that carries the camera; <see cref="RayHit.World"/> for none.</param>
    /// <param name="rays">What rays meet.</param>
    /// <returns>The estimate; method <see cref="OcclusionMethod.None"/> when nothing of the cuboid is in the image.</returns>
    public OcclusionEstimate Estimate(
        Camera camera, Cuboid cuboid, CuboidProjection projection, int entity, int ignoredEntity, IRayCaster rays)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(cuboid, nameof(cuboid));
        Guard.NotNull(projection, nameof(projection));
        Guard.NotNull(rays, nameof(rays));
        if (projection.Box is not { } box)
        {
            return new OcclusionEstimate(0, 0, 0, OcclusionMethod.None);
        }

        int cast = 0;
        int visible = 0;
        int hidden = 0;
        int onCuboid = 0;
        int nearerThanCuboid = 0;
        foreach (Vector2D pixel in SamplePixels(projection, box))
        {
            Ray ray = camera.RayThrough(pixel.X, pixel.Y);
            if (cuboid.Intersect(ray) is not { } span)
            {
                continue;
            }

            onCuboid++;
            cast++;
            RayHit? first = rays.Cast(ray, span.Exit + EntryMargin, ignoredEntity);
            if (first is { } hit && hit.Entity == entity)
            {
                visible++;
                continue;
            }

            if (first is not { } blocker || blocker.Distance >= span.Entry)
            {
                continue;
            }

            nearerThanCuboid++;
            cast++;
            double start = Math.Max(0, span.Entry - EntryMargin);
            RayHit? second = rays.Cast(new Ray(ray.At(start), ray.Direction), span.Exit - start + EntryMargin, ignoredEntity);
            hidden += second is { } own && own.Entity == entity ? 1 : 0;
        }

        int onObject = visible + hidden;
        if (onObject > 0)
        {
            return new OcclusionEstimate((double)hidden / onObject, onObject, cast, OcclusionMethod.Rays);
        }

        return onCuboid == 0
            ? new OcclusionEstimate(0, 0, cast, OcclusionMethod.None)
            : new OcclusionEstimate((double)nearerThanCuboid / onCuboid, onCuboid, cast, OcclusionMethod.CuboidRays);
    }

    private IEnumerable<Vector2D> SamplePixels(CuboidProjection projection, Box2D box)
    {
        const double stepX = 1 / PlasticNumber;
        const double stepY = 1 / (PlasticNumber * PlasticNumber);
        int found = 0;
        for (int i = 1; i <= _samples * TriesPerSample && found < _samples; i++)
        {
            var pixel = new Vector2D(
                box.XMin + (box.Width * Fraction(0.5 + (i * stepX))),
                box.YMin + (box.Height * Fraction(0.5 + (i * stepY))));
            if (ConvexPolygon.Contains(projection.Silhouette, pixel))
            {
                found++;
                yield return pixel;
            }
        }
    }

    private static double Fraction(double value) => value - Math.Floor(value);
}
