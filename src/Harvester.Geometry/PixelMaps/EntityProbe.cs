using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Probes a target pixel by pixel with rays that start at its cuboid. Pixels follow the R2 sequence over the silhouette in the image.
/// </summary>
internal sealed class EntityProbe(Camera camera, TargetView view, int ignoredEntity, IRayCaster rays)
{
    private readonly CuboidProbe _probe = new(camera.Pose.Position, view.Target.Cuboid, view.Target.Entity, ignoredEntity, rays);

    /// <summary>Whether a ray through a pixel would hit the object if nothing lay in front of its cuboid.</summary>
    public bool Meets(int column, int row) => _probe.Meets(camera.RayThrough(column + 0.5, row + 0.5));

    /// <summary>Up to a number of pixels spread over the silhouette, except those that are left out.</summary>
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
