using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Rays that start at an entity's cuboid, so that nothing in front of it counts: they tell the object from the gaps around it in its
/// cuboid, hidden or not. Places follow the R2 sequence over the silhouette in the image.
/// </summary>
internal sealed class EntityProbe(Camera camera, TargetView view, int ignoredEntity, IRayCaster rays)
{
    /// <summary>How far outside the cuboid a ray starts and ends, metres, so that a surface on the cuboid's face is met.</summary>
    private const double Margin = 0.01;

    /// <summary>Steps of the R3 sequence, the inverse powers of 1.2207..., the root of x^4 = x + 1.</summary>
    private const double StepX = 0.8191725133961645;
    private const double StepY = 0.6710436067037893;
    private const double StepZ = 0.5497004779019703;

    /// <summary>Whether the object would be met through a pixel if nothing lay in front of its cuboid.</summary>
    public bool Meets(int column, int row) => Meets(camera.RayThrough(column + 0.5, row + 0.5));

    /// <summary>Whether the object would be met by a ray if nothing lay in front of its cuboid.</summary>
    public bool Meets(Ray ray)
    {
        if (view.Target.Cuboid.Intersect(ray) is not { } span)
        {
            return false;
        }

        double start = Math.Max(0, span.Entry - Margin);
        RayHit? hit = rays.Cast(new Ray(ray.At(start), ray.Direction), span.Exit - start + Margin, ignoredEntity);
        return hit is { } met && met.Entity == view.Target.Entity;
    }

    /// <summary>Rays towards points spread evenly in the cuboid, in the image or not.</summary>
    public IEnumerable<Ray> Through(int count)
    {
        Vector3D half = view.Target.Cuboid.HalfExtents;
        Vector3D eye = camera.Pose.Position;
        for (int i = 0; i < count; i++)
        {
            var within = new Vector3D(half.X * Signed(i * StepX), half.Y * Signed(i * StepY), half.Z * Signed(i * StepZ));
            yield return new Ray(eye, view.Target.Cuboid.Centre + view.Target.Cuboid.Axes.ToWorld(within) - eye);
        }

        static double Signed(double value) => (2 * (0.5 + value - Math.Floor(0.5 + value))) - 1;
    }

    /// <summary>Up to a number of pixels spread over the silhouette, without those that are left out.</summary>
    public IEnumerable<(int Column, int Row)> Spread(int count, Func<int, int, bool> leaveOut)
    {
        const int triesPerPixel = 8;
        int found = 0;
        for (int i = 0; i < count * triesPerPixel && found < count; i++)
        {
            if (view.SpreadPixel(i) is { } pixel && !leaveOut(pixel.Column, pixel.Row))
            {
                found++;
                yield return pixel;
            }
        }
    }
}
