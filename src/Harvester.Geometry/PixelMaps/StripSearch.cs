using System;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Follows strips through cells. What was met inside a cell and hardly shows on its border may be a strip that crosses it: where the
/// straight ways from there along row and column leave the cell tells, the nearest first.
/// </summary>
internal static class StripSearch
{
    /// <summary>A number of which the border shows no more pixels than this may be that of a strip.</summary>
    private const int StripPixels = 3;

    /// <summary>The next place on the border to ask, or null. The border's runs must have been collected.</summary>
    public static Place? Wanted(CellBorder border, PixelSamples samples)
    {
        MapCell cell = border.Cell;
        for (int row = cell.Top + 1; row < cell.Bottom; row++)
        {
            for (int column = cell.Left + 1; column < cell.Right; column++)
            {
                if (samples.IsCast(column, row) && HardlyShows(border, samples.Number(column, row))
                    && WayOut(cell, samples, column, row) is { } place)
                {
                    return place;
                }
            }
        }

        return null;
    }

    private static Place? WayOut(MapCell cell, PixelSamples samples, int column, int row)
    {
        (int Away, int Column, int Row)[] ways =
        [
            (row - cell.Top, column, cell.Top),
            (cell.Bottom - row, column, cell.Bottom),
            (column - cell.Left, cell.Left, row),
            (cell.Right - column, cell.Right, row),
        ];
        Array.Sort(ways);
        int unasked = Array.FindIndex(ways, way => samples.IsUnasked(way.Column, way.Row));
        return unasked < 0 ? null : Place.OfPixel(ways[unasked].Column, ways[unasked].Row);
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
