using Harvester.Geometry.Boxes;

namespace Harvester.Geometry.Visibility;

/// <summary>
/// Casts rays that start at an entity's cuboid, so that nothing in front of it counts. They show whether any of the entity is on a line of
/// sight, hidden or not.
/// </summary>
/// <param name="eye">The camera's position, metres.</param>
/// <param name="cuboid">The entity's cuboid.</param>
/// <param name="entity">The entity's handle.</param>
/// <param name="ignoredEntity">Handle of an entity that rays pass through; <see cref="RayHit.World"/> if there is none.</param>
/// <param name="rays">The ray caster.</param>
internal sealed class CuboidProbe(Vector3D eye, Cuboid cuboid, int entity, int ignoredEntity, IRayCaster rays)
{
    /// <summary>
    /// Distance outside the cuboid at which a ray starts and ends, metres, so that a surface on the cuboid's face is hit.
    /// </summary>
    public const double Margin = 0.01;

    /// <summary>Surfaces that close behind the one that stops a ray count as the same, metres.</summary>
    public const double Thickness = 0.05;

    /// <summary>Steps of the R3 sequence, the inverse powers of 1.2207..., the root of x^4 = x + 1.</summary>
    private const double StepX = 0.8191725133961645;
    private const double StepY = 0.6710436067037893;
    private const double StepZ = 0.5497004779019703;

    /// <summary>Whether a ray from the camera would hit the entity if nothing lay in front of its cuboid.</summary>
    public bool Meets(Ray ray)
    {
        if (cuboid.Intersect(ray) is not { } span)
        {
            return false;
        }

        return MeetsFrom(ray, Math.Max(0, span.Entry - Margin), span.Exit);
    }

    /// <summary>Whether a ray from the camera that is stopped inside the cuboid would hit the entity behind what stops it.</summary>
    public bool MeetsBehind(Ray ray, double stoppedAt)
    {
        double start = stoppedAt + Thickness;
        return cuboid.Intersect(ray) is { } span && start < span.Exit && MeetsFrom(ray, start, span.Exit);
    }

    /// <summary>Rays from the camera to points spread evenly in the cuboid, inside and outside the image.</summary>
    public IEnumerable<Ray> Through(int count)
    {
        Vector3D half = cuboid.HalfExtents;
        for (int i = 0; i < count; i++)
        {
            // Point i of the sequence is ½ + i·step modulo 1 on each axis, mapped from [0, 1) to [-1, 1).
            var within = new Vector3D(half.X * Signed(i * StepX), half.Y * Signed(i * StepY), half.Z * Signed(i * StepZ));
            yield return new Ray(eye, cuboid.Centre + cuboid.Axes.ToWorld(within) - eye);
        }

        static double Signed(double value) => (2 * (0.5 + value - Math.Floor(0.5 + value))) - 1;
    }

    private bool MeetsFrom(Ray ray, double start, double exit)
    {
        RayHit? hit = rays.Cast(new Ray(ray.At(start), ray.Direction), exit - start + Margin, ignoredEntity);
        return hit is { } met && met.Entity == entity;
    }
}
