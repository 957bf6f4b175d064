using System.Collections;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>The pixels of an image that belong to an object: the result of Algorithm 4. Maps of one image size combine with OR.</summary>
public sealed class PixelMap
{
    private readonly BitArray _bits;

    /// <summary>Creates an empty map.</summary>
    public PixelMap(ImageSize image)
    {
        Image = image;
        _bits = new BitArray(image.PixelCount);
    }

    /// <summary>The image's size, pixels.</summary>
    public ImageSize Image { get; }

    /// <summary>The number of pixels that belong to the object.</summary>
    public int Count { get; private set; }

    /// <summary>Whether the pixel in a column and row belongs to the object.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The pixel is outside the image.</exception>
    public bool this[int column, int row]
    {
        get => _bits[Index(column, row)];
        set
        {
            int index = Index(column, row);
            Count += (value ? 1 : 0) - (_bits[index] ? 1 : 0);
            _bits[index] = value;
        }
    }

    /// <summary>The pixels that belong to this object or another.</summary>
    /// <exception cref="ArgumentException">The maps have different image sizes.</exception>
    public PixelMap Or(PixelMap other)
    {
        if (Guard.NotNull(other, nameof(other)).Image != Image)
        {
            throw new ArgumentException("Pixel maps combine only within one image size.", nameof(other));
        }

        var combined = new PixelMap(Image);
        for (int row = 0; row < Image.Height; row++)
        {
            for (int column = 0; column < Image.Width; column++)
            {
                combined[column, row] = this[column, row] || other[column, row];
            }
        }

        return combined;
    }

    private int Index(int column, int row)
    {
        if (column < 0 || column >= Image.Width)
        {
            throw new ArgumentOutOfRangeException(nameof(column), column, "The column is outside the image.");
        }

        if (row < 0 || row >= Image.Height)
        {
            throw new ArgumentOutOfRangeException(nameof(row), row, "The row is outside the image.");
        }

        return (row * Image.Width) + column;
    }
}
