using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Tests.Visibility;

/// <summary>The estimate of an object's occlusion with a ray for every sample, and a second for each that something hides.</summary>
internal sealed class EveryRayOcclusion(IRayCaster rays)
{
    private const int MoreSamples = 4;
    private const int Probes = 64;

    public int RaysCast { get; private set; }

    public OcclusionEstimate Estimate(Camera camera, Cuboid cuboid, CuboidProjection projection, int entity, int ignored, int samples)
    {
        if (projection.Box is not { } box)
        {
            return new OcclusionEstimate(0, 0, 0, OcclusionMethod.None) { Sight = Sight.Unseen };
        }

        int visible = 0,
            hidden = 0,
            onCuboid = 0,
            stopped = 0;
        foreach (Vector2D pixel in SilhouetteSamples.Of(projection, box, MoreSamples * samples))
        {
            if (onCuboid >= samples && (visible + hidden > 0 || stopped == onCuboid))
            {
                break;
            }

            Ray ray = camera.RayThrough(pixel.X, pixel.Y);
            if (cuboid.Intersect(ray) is not { } span)
            {
                continue;
            }

            onCuboid++;
            RayHit? first = Cast(ray, span.Exit + CuboidProbe.Margin, ignored);
            if (first?.Entity == entity)
            {
                visible++;
            }
            else if (first is { } blocker && blocker.Distance < span.Entry)
            {
                stopped++;
                hidden += Meets(cuboid, ray, entity, ignored) ? 1 : 0;
            }
        }

        return visible + hidden > 0
                ? new OcclusionEstimate((double)hidden / (visible + hidden), visible + hidden, RaysCast, OcclusionMethod.Rays)
                {
                    Sight = visible > 0 ? Sight.Seen : Sight.Unseen,
                }
            : onCuboid == 0 ? new OcclusionEstimate(0, 0, 0, OcclusionMethod.None) { Sight = Sight.Unseen }
            : stopped == onCuboid ? new OcclusionEstimate(1, onCuboid, RaysCast, OcclusionMethod.CuboidRays) { Sight = Sight.Unseen }
            : new OcclusionEstimate(0, 0, RaysCast, OcclusionMethod.None) { Sight = SightOfUnhit(camera, cuboid, entity, ignored) };
    }

    private Sight SightOfUnhit(Camera camera, Cuboid cuboid, int entity, int ignored) =>
        new CuboidProbe(camera.Pose.Position, cuboid, entity, ignored, rays).Through(Probes).Any(ray => Meets(cuboid, ray, entity, ignored))
            ? Sight.Unseen
            : Sight.Undetermined;

    private bool Meets(Cuboid cuboid, Ray ray, int entity, int ignored)
    {
        if (cuboid.Intersect(ray) is not { } span)
        {
            return false;
        }

        double start = Math.Max(0, span.Entry - CuboidProbe.Margin);
        return Cast(new Ray(ray.At(start), ray.Direction), span.Exit - start + CuboidProbe.Margin, ignored)?.Entity == entity;
    }

    private RayHit? Cast(Ray ray, double distance, int ignored)
    {
        RaysCast++;
        return rays.Cast(ray, distance, ignored);
    }
}
