using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>The cells that a map starts from: a grid over the image, of which those that meet an object's box are kept.</summary>
internal static class CellGrid
{
    /// <summary>Coarse to fine: corners of this many cells apart are asked first, then of half as many, and so on.</summary>
    private const int CoarsestStride = 4;

    public static List<MapCell> Cells(ImageSize image, int size, IReadOnlyList<TargetView> views)
    {
        List<int> columns = Lines(image.Width, size);
        List<int> rows = Lines(image.Height, size);
        var cells = new List<MapCell>();
        for (int r = 0; r < rows.Count - 1; r++)
        {
            for (int c = 0; c < columns.Count - 1; c++)
            {
                var cell = new MapCell(columns[c], rows[r], columns[c + 1], rows[r + 1]);
                foreach (TargetView view in views)
                {
                    if (view.Spans.BoxMeets(cell))
                    {
                        cells.Add(cell);
                        break;
                    }
                }
            }
        }

        return cells;
    }

    /// <summary>The corners of cells, from a coarse grid to the whole.</summary>
    public static IEnumerable<Place> Corners(IReadOnlyList<MapCell> cells, int size)
    {
        for (int stride = CoarsestStride; stride >= 1; stride /= 2)
        {
            foreach (MapCell cell in cells)
            {
                foreach ((int column, int row) in new[] { (cell.Left, cell.Top), (cell.Right, cell.Top), (cell.Left, cell.Bottom), (cell.Right, cell.Bottom) })
                {
                    if (column / size % stride == 0 && row / size % stride == 0)
                    {
                        yield return Place.OfPixel(column, row);
                    }
                }
            }
        }
    }

    // The last line is the last pixel, however near the one before it; an image of one pixel has a cell of that pixel.
    private static List<int> Lines(int length, int size)
    {
        var lines = new List<int>();
        for (int at = 0; at < length - 1; at += size)
        {
            lines.Add(at);
        }

        lines.Add(length - 1);
        if (lines.Count == 1)
        {
            lines.Add(length - 1);
        }

        return lines;
    }
}
