using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Algorithm 4 of the thesis: a ray through the centre of every pixel of a region; the pixel belongs to the entity that the ray hits first.
/// Exact for the given ray caster, and takes as many rays as pixels.
/// </summary>
public static class ExhaustivePixelMapper
{
    /// <summary>The maximum length of a ray in the thesis, metres.</summary>
    public const double RayLength = 10_000;

    /// <summary>Labels the pixels whose centres lie in a region of the image.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="region">The region, pixels; the part outside the image is ignored.</param>
    /// <param name="numberOf">The number in the map of an entity's handle; 0 for entities that are not labelled.</param>
    /// <param name="ignoredEntity">Handle of an entity that rays pass through; <see cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster.</param>
    public static InstanceMap Map(Camera camera, Box2D region, Func<int, ushort> numberOf, int ignoredEntity, IRayCaster rays)
    {
        var map = new InstanceMap(Guard.NotNull(camera, nameof(camera)).Image);
        MapInto(map, camera, region, numberOf, ignoredEntity, rays);
        return map;
    }

    /// <summary>Labels the pixels of a map whose centres lie in a region of the image, and leaves the others unchanged.</summary>
    /// <param name="map">The map, of the camera's image size.</param>
    /// <param name="camera">The camera.</param>
    /// <param name="region">The region, pixels; the part outside the image is ignored.</param>
    /// <param name="numberOf">The number in the map of an entity's handle; 0 for entities that are not labelled.</param>
    /// <param name="ignoredEntity">Handle of an entity that rays pass through; <see cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster.</param>
    /// <exception cref="ArgumentException">The map has another image size.</exception>
    public static void MapInto(InstanceMap map, Camera camera, Box2D region, Func<int, ushort> numberOf, int ignoredEntity, IRayCaster rays)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(numberOf, nameof(numberOf));
        Guard.NotNull(rays, nameof(rays));
        if (Guard.NotNull(map, nameof(map)).Image != camera.Image)
        {
            throw new ArgumentException("The map is not of the camera's image size.", nameof(map));
        }

        if (region.Intersect(camera.Image.Bounds) is not { } inImage)
        {
            return;
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
    }
}
