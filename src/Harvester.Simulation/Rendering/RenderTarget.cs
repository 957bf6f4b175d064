namespace Harvester.Simulation.Rendering;

/// <summary>A rendered image with the depth and entity of each pixel; reused from frame to frame. Rows from the top.</summary>
public sealed class RenderTarget
{
    /// <summary>Creates a target.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A side is less than 1.</exception>
    public RenderTarget(int width, int height)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        Width = width;
        Height = height;
        int pixels = checked(width * height);
        Colour = new byte[checked(pixels * 3)];
        Handles = new int[pixels];
        Depth = new float[pixels];
        Kinds = new SurfaceKind[pixels];
    }

    /// <summary>Width in pixels.</summary>
    public int Width { get; }

    /// <summary>Height in pixels.</summary>
    public int Height { get; }

    /// <summary>Red, green, blue of each pixel.</summary>
    public byte[] Colour { get; }

    /// <summary>Handle of the entity visible at each pixel's centre; 0 for the static world and the sky.</summary>
    public int[] Handles { get; }

    /// <summary>
    /// What the surface visible at each pixel's centre is. A road marking is shown where it covers at least half of the pixel.
    /// </summary>
    public SurfaceKind[] Kinds { get; }

    /// <summary>
    /// Distance along the camera's forward axis of what is visible at each pixel's centre, metres; positive infinity for the sky.
    /// </summary>
    public float[] Depth { get; }
}
