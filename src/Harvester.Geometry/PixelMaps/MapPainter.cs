using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>Paints the cells: sampled pixels as they are, the others by the cells' straight outlines.</summary>
internal sealed class MapPainter(ImageSize image, PixelSamples samples, CellExaminer examiner, InstanceMap unasked)
{
    /// <summary>Paints cells into a new map.</summary>
    /// <param name="untouched">Cells without samples: they show the map that is guessed without rays.</param>
    /// <param name="touched">All others.</param>
    public InstanceMap Paint(IEnumerable<MapCell> untouched, IEnumerable<MapCell> touched)
    {
        var map = new InstanceMap(image);
        foreach (MapCell cell in untouched)
        {
            PaintUnasked(map, cell);
        }

        foreach (MapCell cell in touched)
        {
            PaintCell(map, cell);
        }

        samples.CopyKnownTo(map);
        return map;
    }

    private void PaintCell(InstanceMap map, MapCell cell)
    {
        CellBorder border = examiner.Border;
        border.Read(cell);
        border.CollectRuns();
        for (int step = 0; step < cell.BorderLength; step++)
        {
            (int column, int row) = cell.Border(step);
            map[column, row] = (ushort)border.NumberAt(step);
        }

        if (!cell.HasInterior)
        {
            return;
        }

        CellModel? model = examiner.AgreeingModel();
        for (int row = cell.Top + 1; row < cell.Bottom; row++)
        {
            for (int column = cell.Left + 1; column < cell.Right; column++)
            {
                map[column, row] = model is not null
                    ? (ushort)model.NumberAt(column, row)
                    : map[
                        column - cell.Left < cell.Right - column ? cell.Left : cell.Right,
                        row - cell.Top < cell.Bottom - row ? cell.Top : cell.Bottom];
            }
        }
    }

    private void PaintUnasked(InstanceMap map, MapCell cell)
    {
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            for (int column = cell.Left; column <= cell.Right; column++)
            {
                map[column, row] = unasked[column, row];
            }
        }
    }
}
