using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Paint;

/// <summary>An image in which paint is looked for.</summary>
public sealed class PaintImage
{
    /// <summary>Creates an image.</summary>
    /// <param name="camera">The camera, with the size of the image.</param>
    /// <param name="rgb">The image, 8 bits each of red, green and blue, row by row.</param>
    /// <param name="ground">The ground.</param>
    /// <param name="hidden">One byte per pixel, row by row, other than 0 where something else than ground is seen, such as a vehicle;
    /// null if nothing is.</param>
    /// <exception cref="System.ArgumentException">An array has another size than the camera's image.</exception>
    public PaintImage(Camera camera, byte[] rgb, IPaintGround ground, byte[]? hidden)
    {
        Camera = Guard.NotNull(camera, nameof(camera));
        Rgb = Guard.NotNull(rgb, nameof(rgb));
        Ground = Guard.NotNull(ground, nameof(ground));
        Hidden = hidden;
        if (rgb.Length != 3 * camera.Image.PixelCount || (hidden is not null && hidden.Length != camera.Image.PixelCount))
        {
            throw new System.ArgumentException("The arrays must have the size of the camera's image.", nameof(rgb));
        }
    }

    /// <summary>The camera.</summary>
    public Camera Camera { get; }

    /// <summary>The image, 8 bits each of red, green and blue, row by row.</summary>
    public byte[] Rgb { get; }

    /// <summary>The ground.</summary>
    public IPaintGround Ground { get; }

    /// <summary>One byte per pixel, other than 0 where something else than ground is seen; null if nothing is.</summary>
    public byte[]? Hidden { get; }

    /// <summary>
    /// Depth along the camera's axis, metres, row by row, not finite where nothing is seen and 0 where it is unknown; null without a depth
    /// map. Ground behind something nearer is not searched for paint.
    /// </summary>
    public float[]? Depths { get; init; }
}
