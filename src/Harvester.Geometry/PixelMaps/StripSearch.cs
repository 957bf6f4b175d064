namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Follows thin strips through cells. A number that was hit inside a cell but has few pixels on its border may be a strip that crosses the
/// border: the search goes from the hit straight along its row and column to the border, the nearest side first.
/// </summary>
internal static class StripSearch
{
    /// <summary>Maximum number of border pixels of a number that may be a strip.</summary>
    private const int StripPixels = 3;

    /// <summary>The next point on the border to sample, or null. The border's runs must have been collected.</summary>
    public static SubpixelPoint? Wanted(CellBorder border, PixelSamples samples)
    {
        MapCell cell = border.Cell;
        for (int row = cell.Top + 1; row < cell.Bottom; row++)
        {
            for (int column = cell.Left + 1; (column = samples.NextCast(column, cell.Right, row)) < cell.Right; column++)
            {
                if (HardlyShows(border, samples.Number(column, row)) && WayOut(cell, samples, column, row) is { } place)
                {
                    return place;
                }
            }
        }

        return null;
    }

    private static SubpixelPoint? WayOut(MapCell cell, PixelSamples samples, int column, int row)
    {
        (int Away, int Column, int Row)[] ways =
        [
            (row - cell.Top, column, cell.Top),
            (cell.Bottom - row, column, cell.Bottom),
            (column - cell.Left, cell.Left, row),
            (cell.Right - column, cell.Right, row),
        ];
        Array.Sort(ways);
        int unasked = Array.FindIndex(ways, way => samples.IsUnsampled(way.Column, way.Row));
        return unasked < 0 ? null : SubpixelPoint.OfPixel(ways[unasked].Column, ways[unasked].Row);
    }

    private static bool HardlyShows(CellBorder border, int number)
    {
        int shown = 0;
        foreach (BorderRun run in border.Runs)
        {
            shown += run.Number == number ? run.End - run.Start + 1 : 0;
        }

        return shown <= StripPixels;
    }
}
