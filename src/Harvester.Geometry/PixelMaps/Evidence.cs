namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Removes what is drawn without evidence: pixels of objects that no ray has hit, which are guessed from their cuboids, and pixels between
/// rays where an object cannot be, since an outline drawn across a cell may reach beyond the box of the object's cuboid.
/// </summary>
internal static class Evidence
{
    /// <summary>Clears the pixels without evidence.</summary>
    /// <param name="map">The map, with numbers of the targets only.</param>
    /// <param name="samples">The samples so far.</param>
    /// <param name="targets">All targets.</param>
    /// <param name="greatest">The greatest of their numbers.</param>
    public static void Demand(InstanceMap map, PixelSamples samples, IReadOnlyList<MapTarget> targets, int greatest)
    {
        var boxes = new Box2D?[greatest + 1];
        foreach (MapTarget target in targets)
        {
            boxes[target.Number] = samples.HasMet(target.Number) ? target.Projection.Box : null;
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
