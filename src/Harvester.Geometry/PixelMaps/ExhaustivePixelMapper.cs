using System;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Algorithm 4 of the thesis to the letter: a ray through the centre of every pixel of a region; the pixel belongs to the entity
/// that the ray meets first. Exact for the ray caster at hand, and as many rays as pixels.
/// </summary>
public static class ExhaustivePixelMapper
{
    /// <summary>The thesis's length of a ray, metres.</summary>
    public const double RayLength = 10_000;

    /// <summary>Labels the pixels whose centres lie in a region of the image.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="region">The region, pixels; what of it lies outside the image is left out.</param>
    /// <param name="numberOf">The number in the map of an entity's handle; 0 for entities that are not labelled.</param>
    /// <param name="ignoredEntity">Handle of an entity that rays pass through; <see cref="RayHit.World"/> for none.</param>
    /// <param name="rays">What rays meet.</param>
    public static InstanceMap Map(Camera camera, Box2D region, Func<int, ushort> numberOf, int ignoredEntity, IRayCaster rays)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(numberOf, nameof(numberOf));
        Guard.NotNull(rays, nameof(rays));
        var map = new InstanceMap(camera.Image);
        if (region.Intersect(camera.Image.Bounds) is not { } inImage)
        {
            return map;
        }

        int firstColumn = (int)Math.Ceiling(inImage.XMin - 0.5);
        int firstRow = (int)Math.Ceiling(inImage.YMin - 0.5);
        for (int row = firstRow; row + 0.5 < inImage.YMax; row++)
        {
            for (int column = firstColumn; column + 0.5 < inImage.XMax; column++)
            {
                RayHit? hit = rays.Cast(camera.RayThrough(column + 0.5, row + 0.5), RayLength, ignoredEntity);
                map[column, row] = hit is { Entity: not RayHit.World } seen ? numberOf(seen.Entity) : (ushort)0;
            }
        }

        return map;
    }
}
