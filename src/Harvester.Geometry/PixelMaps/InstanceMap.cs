using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>For each pixel of an image, the number of the object visible there; 0 if there is none.</summary>
public sealed class InstanceMap
{
    private readonly ushort[] _ids;

    /// <summary>Creates a map without objects.</summary>
    public InstanceMap(ImageSize image)
    {
        Image = image;
        _ids = new ushort[image.PixelCount];
    }

    /// <summary>The image's size, pixels.</summary>
    public ImageSize Image { get; }

    /// <summary>
    /// All numbers, row by row from the upper left, without padding. This is the map's own storage: writing to it changes the map.
    /// </summary>
    public ushort[] Ids => _ids;

    /// <summary>The number at a column and row.</summary>
    /// <exception cref="IndexOutOfRangeException">The pixel is outside the storage.</exception>
    public ushort this[int column, int row]
    {
        get => _ids[(row * Image.Width) + column];
        set => _ids[(row * Image.Width) + column] = value;
    }

    /// <summary>Number of pixels of each number, including 0.</summary>
    /// <param name="greatest">The greatest number that the map may have.</param>
    internal int[] PixelCounts(int greatest)
    {
        var counts = new int[greatest + 1];
        foreach (ushort number in _ids)
        {
            counts[number]++;
        }

        return counts;
    }

    /// <summary>The pixels of one object.</summary>
    public PixelMap MapOf(ushort id)
    {
        var map = new PixelMap(Image);
        for (int row = 0; row < Image.Height; row++)
        {
            for (int column = 0; column < Image.Width; column++)
            {
                if (this[column, row] == id)
                {
                    map[column, row] = true;
                }
            }
        }

        return map;
    }

    /// <summary>The box around the pixels of one object, or null if it has none.</summary>
    public Box2D? BoundsOf(ushort id)
    {
        Box2D? bounds = null;
        for (int row = 0; row < Image.Height; row++)
        {
            for (int column = 0; column < Image.Width; column++)
            {
                if (this[column, row] == id)
                {
                    var pixel = new Box2D(column, row, column + 1, row + 1);
                    bounds = bounds?.Union(pixel) ?? pixel;
                }
            }
        }

        return bounds;
    }
}
