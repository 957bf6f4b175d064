using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>When each part of an image last changed, so that what has not changed need not be looked at again.</summary>
internal sealed class ChangeStamps
{
    private const int TileSize = 8;
    private readonly int _across;
    private readonly int[] _stamps;

    public ChangeStamps(ImageSize image)
    {
        _across = (image.Width + TileSize - 1) / TileSize;
        _stamps = new int[_across * ((image.Height + TileSize - 1) / TileSize)];
    }

    /// <summary>The number of changes so far.</summary>
    public int Now { get; private set; }

    /// <summary>A pixel has changed.</summary>
    public void Change(int column, int row) => _stamps[((row / TileSize) * _across) + (column / TileSize)] = ++Now;

    /// <summary>Whether a pixel of a cell, or one close to it, may have changed after a moment.</summary>
    public bool HasChanged(MapCell cell, int after)
    {
        for (int row = cell.Top / TileSize; row <= cell.Bottom / TileSize; row++)
        {
            for (int column = cell.Left / TileSize; column <= cell.Right / TileSize; column++)
            {
                if (_stamps[(row * _across) + column] > after)
                {
                    return true;
                }
            }
        }

        return false;
    }
}
