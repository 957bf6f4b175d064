using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>The initial cells of a map: a grid over the image, of which the cells that meet an object's box are kept.</summary>
internal sealed class CellGrid
{
    public CellGrid(ImageSize image, int size, IReadOnlyList<TargetView> views)
    {
        Columns = Lines(image.Width, size);
        Rows = Lines(image.Height, size);
        for (int r = 0; r < Rows.Count - 1; r++)
        {
            for (int c = 0; c < Columns.Count - 1; c++)
            {
                var cell = new MapCell(Columns[c], Rows[r], Columns[c + 1], Rows[r + 1]);
                foreach (TargetView view in views)
                {
                    if (view.Spans.BoxMeets(cell))
                    {
                        Cells.Add(cell);
                        break;
                    }
                }
            }
        }
    }

    /// <summary>The image's columns at which cells have their sides.</summary>
    public List<int> Columns { get; }

    /// <summary>The image's rows at which cells have their sides.</summary>
    public List<int> Rows { get; }

    public List<MapCell> Cells { get; } = [];

    /// <summary>The corner pixels of the cells.</summary>
    public HashSet<(int Column, int Row)> Corners()
    {
        var corners = new HashSet<(int Column, int Row)>();
        foreach (MapCell cell in Cells)
        {
            corners.UnionWith([(cell.Left, cell.Top), (cell.Right, cell.Top), (cell.Left, cell.Bottom), (cell.Right, cell.Bottom)]);
        }

        return corners;
    }

    // The last line is the last pixel, however close to the line before it; an image of one pixel has a cell of one pixel.
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
