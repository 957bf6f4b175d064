using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Capture.Labelling;

/// <summary>The boxes around all objects of an instance map, in one pass over its pixels.</summary>
internal static class InstanceBounds
{
    /// <summary>The box around the pixels of each number; null for numbers without pixels.</summary>
    public static Box2D?[] Of(InstanceMap map)
    {
        var bounds = new Box2D?[ushort.MaxValue + 1];
        for (int row = 0; row < map.Image.Height; row++)
        {
            for (int column = 0; column < map.Image.Width; column++)
            {
                ushort id = map[column, row];
                if (id != 0)
                {
                    var pixel = new Box2D(column, row, column + 1, row + 1);
                    bounds[id] = bounds[id]?.Union(pixel) ?? pixel;
                }
            }
        }

        return bounds;
    }
}
