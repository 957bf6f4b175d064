namespace Harvester.Geometry.Cameras;

/// <summary>
/// Width and height of an image in pixels, each from 1 to 65,535. The default value is not a size, and cameras reject it.
/// </summary>
public readonly record struct ImageSize
{
    /// <summary>Creates the size of an image.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A side is less than 1 or more than 65,535.</exception>
    public ImageSize(int width, int height)
    {
        const int maxSide = 65_535;
        if (width is < 1 or > maxSide)
        {
            throw new ArgumentOutOfRangeException(nameof(width), width, "An image is 1 to 65,535 pixels wide.");
        }

        if (height is < 1 or > maxSide)
        {
            throw new ArgumentOutOfRangeException(nameof(height), height, "An image is 1 to 65,535 pixels high.");
        }

        Width = width;
        Height = height;
    }

    /// <summary>Width, pixels; at least 1.</summary>
    public int Width { get; }

    /// <summary>Height, pixels; at least 1.</summary>
    public int Height { get; }

    /// <summary>Width divided by height, as if pixels were square.</summary>
    public double Aspect => (double)Width / Height;

    /// <summary>The number of pixels.</summary>
    public int PixelCount => checked(Width * Height);

    /// <summary>The rectangle that the image covers, in pixels.</summary>
    public Box2D Bounds => new(0, 0, Width, Height);

    /// <summary>The size as text, such as 800x600.</summary>
    public override string ToString() => FormattableString.Invariant($"{Width}x{Height}");

    /// <summary>Whether the image has a pixel in this column and row.</summary>
    public bool Contains(int column, int row) => column >= 0 && row >= 0 && column < Width && row < Height;
}
