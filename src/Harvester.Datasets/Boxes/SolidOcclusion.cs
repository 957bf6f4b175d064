using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Boxes;

/// <summary>
/// How much of a solid cuboid is hidden by other solid cuboids. Rays through points of the silhouette in the image, not only through the
/// centres of pixels, so that a cuboid smaller than a pixel has a fraction too.
/// </summary>
internal static class SolidOcclusion
{
    /// <summary>Number of rays; the R2 sequence is off by a few of them on a half plane.</summary>
    private const int Samples = 256;

    /// <summary>
    /// Surfaces nearer to each other than this coincide, metres: the cuboids of labels are rounded to 0.1 mm a component.
    /// </summary>
    private const double CoincidenceMetres = 0.001;

    /// <summary>
    /// The fraction of a cuboid's silhouette in the image on which another cuboid is nearer, 0 to 1; null if none of it is in the image.
    /// </summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboids">All cuboids.</param>
    /// <param name="index">Which of them.</param>
    /// <param name="projection">Its projection by the camera.</param>
    public static double? FractionOf(Camera camera, IReadOnlyList<Cuboid> cuboids, int index, CuboidProjection projection)
    {
        if (projection.Box is null)
        {
            return null;
        }

        int onCuboid = 0;
        int hidden = 0;
        foreach (Vector2D pixel in PolygonSamples.Of(ConvexPolygon.Clip(projection.Silhouette, camera.Image.Bounds), Samples))
        {
            // Near the hull of a distorted outline a ray can pass the cuboid.
            Ray ray = camera.RayThrough(pixel.X, pixel.Y);
            if (cuboids[index].Intersect(ray) is { } own)
            {
                onCuboid++;
                hidden += cuboids.Any(other => other.Intersect(ray) is { } span && span.Entry < own.Entry - CoincidenceMetres) ? 1 : 0;
            }
        }

        return onCuboid > 0 ? (double)hidden / onCuboid : null;
    }
}
