using System.Collections.Generic;
using System.Linq;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// The cells that are done with as far as is known: understood, or too small to count. Those that prove otherwise go back to the queue.
/// </summary>
internal sealed class SettledCells(CellExaminer examiner, CellQueue queue, double errorFraction)
{
    private readonly List<MapCell> _cells = [];

    public IReadOnlyList<MapCell> Cells => _cells;

    public void Add(MapCell cell) => _cells.Add(cell);

    /// <summary>Looks at all cells again: what was settled may not fit what its neighbours or a search have learnt since.</summary>
    /// <returns>Whether a cell is to be treated again.</returns>
    public bool Review()
    {
        foreach (MapCell cell in TakeAll())
        {
            CellVerdict verdict = examiner.Examine(cell);
            double priority = CellQueue.PriorityOf(cell, verdict.Weight);
            if (verdict.IsUnderstood || priority < errorFraction)
            {
                _cells.Add(cell);
            }
            else
            {
                queue.Add(priority, cell);
            }
        }

        return queue.Count > 0;
    }

    /// <summary>
    /// Treats cells with certain pixels that are not understood before all others, however little they count for what an object shows.
    /// </summary>
    /// <param name="pixels">The pixels.</param>
    /// <returns>Whether there are such cells.</returns>
    public bool Reopen(IReadOnlyCollection<(int Column, int Row)> pixels)
    {
        foreach (MapCell cell in TakeAll())
        {
            if (pixels.Any(pixel => cell.Contains(pixel.Column, pixel.Row)) && !examiner.Examine(cell).IsUnderstood)
            {
                queue.Add(double.MaxValue, cell);
            }
            else
            {
                _cells.Add(cell);
            }
        }

        return queue.Count > 0;
    }

    private List<MapCell> TakeAll()
    {
        List<MapCell> cells = [.. _cells];
        _cells.Clear();
        return cells;
    }
}
