using System.Collections.Generic;

namespace Harvester.Geometry.PixelMaps;

/// <summary>Takes back what is drawn where an object cannot be: an outline drawn across a cell may reach beyond the box of the object's cuboid.</summary>
internal static class BoxClip
{
    /// <summary>Empties pixels that no ray asked and that lie beyond the box of their object.</summary>
    /// <param name="map">The map, with numbers of the targets only.</param>
    /// <param name="samples">What rays have told.</param>
    /// <param name="targets">All targets.</param>
    public static void TakeBack(InstanceMap map, PixelSamples samples, IReadOnlyList<MapTarget> targets)
    {
        var boxes = new Dictionary<ushort, Box2D?>();
        foreach (MapTarget target in targets)
        {
            boxes[target.Number] = target.Projection.Box;
        }

        for (int row = 0; row < map.Image.Height; row++)
        {
            for (int column = 0; column < map.Image.Width; column++)
            {
                if (map[column, row] is not 0 and var number && !samples.IsCast(column, row) && !Meets(boxes[number], column, row))
                {
                    map[column, row] = 0;
                }
            }
        }
    }

    private static bool Meets(Box2D? box, int column, int row) =>
        box is { } some && column + 1 > some.XMin && column < some.XMax && row + 1 > some.YMin && row < some.YMax;
}
