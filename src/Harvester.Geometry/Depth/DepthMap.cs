using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Depth;

/// <summary>Depths of all pixels of an image, and how wrong each may be.</summary>
/// <param name="image">The image's size, pixels.</param>
public sealed class DepthMap(ImageSize image)
{
    /// <summary>The image's size, pixels.</summary>
    public ImageSize Image { get; } = image;

    /// <summary>
    /// Depth along the camera's axis, metres, row by row; positive infinity where nothing is seen, NaN where it is unknown.
    /// </summary>
    public double[] Metres { get; } = new double[image.PixelCount];

    /// <summary>The place of the sample that each depth is taken from, mainly; -1 without one.</summary>
    public int[] Sources { get; } = new int[image.PixelCount];

    /// <summary>The estimated error, metres, row by row; meaningless without a finite depth.</summary>
    public double[] ErrorMetres { get; } = new double[image.PixelCount];
}
