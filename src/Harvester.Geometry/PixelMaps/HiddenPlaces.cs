using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>Decides from the samples around a point whether an object could be visible there at all.</summary>
internal sealed class HiddenPlaces(Camera camera, PixelSamples samples)
{
    /// <summary>Maximum distance in rows and columns of the samples that are used, half an initial cell.</summary>
    private const int Reach = 16;

    /// <summary>Whether all nearby samples of what the pixel shows lie in front of the object's cuboid.</summary>
    public bool IsHidden(MapTarget target, InstanceMap map, int column, int row)
    {
        if (target.Cuboid.Intersect(camera.RayThrough(column + 0.5, row + 0.5)) is not { } span)
        {
            return true;
        }

        return samples.AreWithin(
                span.Entry,
                map[column, row],
                (
                    Math.Max(0, column - Reach),
                    Math.Max(0, row - Reach),
                    Math.Min(camera.Image.Width - 1, column + Reach),
                    Math.Min(camera.Image.Height - 1, row + Reach)
                )
            ) ?? false;
    }
}
