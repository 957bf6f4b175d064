using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Motion;

/// <summary>For each pixel of a picture, where the point that it shows is in another picture. Row by row from the upper left.</summary>
/// <param name="image">The size of both pictures, pixels.</param>
public sealed class FlowField(ImageSize image)
{
    /// <summary>The size of both pictures, pixels.</summary>
    public ImageSize Image { get; } = image;

    /// <summary>How far to the right the point is in the other picture, pixels; 0 without a flow.</summary>
    public float[] U { get; } = new float[image.PixelCount];

    /// <summary>How far down the point is in the other picture, pixels; 0 without a flow.</summary>
    public float[] V { get; } = new float[image.PixelCount];

    /// <summary>What is known of each pixel, as <see cref="FlowFlags"/>.</summary>
    public byte[] Flags { get; } = new byte[image.PixelCount];

    /// <summary>Estimated error of each flow, pixels; null for exact depths.</summary>
    public float[]? ErrorPixels { get; init; }

    /// <summary>
    /// How far the surface has moved in the world from the moment of the other picture to that of this one, metres, along this camera's
    /// right, down and forward: three numbers a pixel, NaN where it is unknown. Null if it was not asked for.
    /// </summary>
    public float[]? Motion { get; init; }

    /// <summary>What is known of a pixel.</summary>
    public FlowFlags At(int pixel) => (FlowFlags)Flags[pixel];
}
