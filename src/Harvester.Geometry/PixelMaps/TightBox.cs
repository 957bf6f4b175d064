using System;

namespace Harvester.Geometry.PixelMaps;

/// <summary>The box around the pixels of a mask, visible or amodal.</summary>
public static class TightBox
{
    /// <summary>The box around all pixels of a map, pixels; null if it has none.</summary>
    public static Box2D? Of(PixelMap map)
    {
        Guard.NotNull(map, nameof(map));
        int left = int.MaxValue;
        int right = -1;
        int top = -1;
        int bottom = -1;
        for (int row = 0; row < map.Image.Height && map.Count > 0; row++)
        {
            for (int column = 0; column < map.Image.Width; column++)
            {
                if (map[column, row])
                {
                    left = Math.Min(left, column);
                    right = Math.Max(right, column);
                    top = top < 0 ? row : top;
                    bottom = row;
                }
            }
        }

        return right < 0 ? null : new Box2D(left, top, right + 1, bottom + 1);
    }
}
