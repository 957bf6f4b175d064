using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Paints the cells: sampled pixels as they are, the others by the cells' straight outlines. What a cell shows depends on the samples in it
/// only, so a cell without new samples is painted as before.
/// </summary>
internal sealed class MapPainter(Camera camera, PixelSamples samples, CellExaminer examiner, IReadOnlyList<TargetView> views)
{
    private readonly Dictionary<MapCell, PaintedCell> _painted = [];
    private ushort[] _numbers = [];
    private ushort[] _row = [];
    private InstanceMap? _unasked;

    /// <summary>Paints cells; later ones cover the borders of those before.</summary>
    /// <param name="map">A map without objects.</param>
    /// <param name="untouched">Cells without samples: they show the map that is guessed without rays.</param>
    /// <param name="touched">All others.</param>
    public void Paint(InstanceMap map, IEnumerable<MapCell> untouched, IEnumerable<MapCell> touched)
    {
        foreach (MapCell cell in untouched)
        {
            PaintUnasked(map, cell);
        }

        foreach (MapCell cell in touched)
        {
            if (!_painted.TryGetValue(cell, out PaintedCell painted) || samples.Changes.HasChanged(cell, painted.PaintedAt))
            {
                painted = Painted(cell);
                _painted[cell] = painted;
            }

            Copy(painted, cell, map);
        }
    }

    private void Copy(PaintedCell painted, MapCell cell, InstanceMap map)
    {
        int width = cell.Width + 1;
        ushort[] uniform = painted.Numbers is null ? RowOf(painted.Number, width) : [];
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            int target = (row * map.Image.Width) + cell.Left;
            if (painted.Numbers is { } numbers)
            {
                Array.Copy(numbers, (row - cell.Top) * width, map.Ids, target, width);
            }
            else
            {
                Array.Copy(uniform, 0, map.Ids, target, width);
            }
        }
    }

    private ushort[] RowOf(ushort number, int width)
    {
        if (_row.Length < width)
        {
            _row = new ushort[width];
        }

        for (int i = 0; i < width; i++)
        {
            _row[i] = number;
        }

        return _row;
    }

    private PaintedCell Painted(MapCell cell)
    {
        int width = cell.Width + 1;
        int count = width * (cell.Height + 1);
        if (_numbers.Length < count)
        {
            _numbers = new ushort[count];
        }

        CellBorder border = examiner.Border;
        border.Read(cell);
        border.CollectRuns();
        for (int step = 0; step < cell.BorderLength; step++)
        {
            (int column, int row) = cell.Border(step);
            _numbers[((row - cell.Top) * width) + column - cell.Left] = (ushort)border.NumberAt(step);
        }

        if (cell.HasInterior)
        {
            PaintInside(cell, width);
        }

        // A cell of one number, the most frequent kind, is kept as the number alone.
        int same = 1;
        while (same < count && _numbers[same] == _numbers[0])
        {
            same++;
        }

        ushort[]? numbers = null;
        if (same < count)
        {
            numbers = new ushort[count];
            Array.Copy(_numbers, numbers, count);
        }

        return new PaintedCell(samples.Changes.Now, _numbers[0], numbers);
    }

    private void PaintInside(MapCell cell, int width)
    {
        CellModel? model = examiner.AgreeingModel();
        for (int row = cell.Top + 1; row < cell.Bottom; row++)
        {
            for (int column = cell.Left + 1; column < cell.Right; column++)
            {
                // A sample first; then the outlines that agree with all samples; without them, as when the work was stopped early, the
                // nearest corner.
                int known = samples.Number(column, row);
                _numbers[((row - cell.Top) * width) + column - cell.Left] =
                    known != PixelSamples.Unknown ? (ushort)known
                    : model is not null ? (ushort)model.NumberAt(column, row)
                    : NearestCorner(cell, width, column, row);
            }
        }
    }

    private ushort NearestCorner(MapCell cell, int width, int column, int row) =>
        _numbers[
            ((row - cell.Top < cell.Bottom - row ? 0 : cell.Height) * width) + (column - cell.Left < cell.Right - column ? 0 : cell.Width)
        ];

    private void PaintUnasked(InstanceMap map, MapCell cell)
    {
        _unasked ??= SilhouettePainter.Paint(camera, [.. Targets()]);
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            for (int column = cell.Left; column <= cell.Right; column++)
            {
                int known = samples.Number(column, row);
                map[column, row] = known != PixelSamples.Unknown ? (ushort)known : _unasked[column, row];
            }
        }
    }

    private IEnumerable<MapTarget> Targets()
    {
        foreach (TargetView view in views)
        {
            yield return view.Target;
        }
    }
}
