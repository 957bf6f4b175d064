namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// The cells that need no more work for now: resolved, or too small to matter. Those that turn out otherwise return to the queue.
/// </summary>
internal sealed class SettledCells(CellExaminer examiner, ChangeStamps changes, CellQueue queue, double errorFraction)
{
    /// <summary>Of a cell that has to be looked at in any case.</summary>
    private const int Never = -1;

    private readonly List<(MapCell Cell, int SettledAt)> _cells = [];

    public IEnumerable<MapCell> Cells => _cells.Select(entry => entry.Cell);

    /// <summary>Adds a cell that has just been understood.</summary>
    public void AddUnderstood(MapCell cell) => _cells.Add((cell, changes.Now));

    /// <summary>Adds a cell that seemed too small to count.</summary>
    public void AddSmall(MapCell cell) => _cells.Add((cell, Never));

    /// <summary>What objects count has changed: all cells have to be looked at again.</summary>
    public void Invalidate()
    {
        for (int i = 0; i < _cells.Count; i++)
        {
            _cells[i] = (_cells[i].Cell, Never);
        }
    }

    /// <summary>
    /// Looks again at the cells in which something has changed: what was settled may not fit what its neighbours or a search have learnt
    /// since.
    /// </summary>
    /// <returns>Whether a cell is to be treated again.</returns>
    public bool Review()
    {
        foreach ((MapCell cell, int settledAt) in TakeAll())
        {
            if (settledAt != Never && !changes.HasChanged(cell, settledAt))
            {
                _cells.Add((cell, settledAt));
                continue;
            }

            CellVerdict verdict = examiner.Examine(cell);
            double priority = CellQueue.PriorityOf(cell, verdict.Weight);
            if (verdict.IsResolved || priority < errorFraction)
            {
                _cells.Add((cell, changes.Now));
            }
            else
            {
                queue.Add(priority, cell);
            }
        }

        return queue.Count > 0;
    }

    /// <summary>Returns unresolved cells with certain pixels to the queue before all others, however small their weight.</summary>
    /// <param name="pixels">The pixels.</param>
    /// <returns>Whether there are such cells.</returns>
    public bool Reopen(IReadOnlyCollection<(int Column, int Row)> pixels)
    {
        foreach ((MapCell cell, int settledAt) in TakeAll())
        {
            if (pixels.Any(pixel => cell.Contains(pixel.Column, pixel.Row)) && !examiner.Examine(cell).IsResolved)
            {
                queue.Add(double.MaxValue, cell);
            }
            else
            {
                _cells.Add((cell, settledAt));
            }
        }

        return queue.Count > 0;
    }

    private List<(MapCell Cell, int SettledAt)> TakeAll()
    {
        List<(MapCell Cell, int SettledAt)> cells = [.. _cells];
        _cells.Clear();
        return cells;
    }
}
