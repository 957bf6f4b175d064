using System.Collections.Generic;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Cells in the order of what their error counts, greatest first; equal ones by their place, so that the order is always the same.
/// </summary>
internal sealed class CellQueue
{
    /// <summary>Of a cell that is not understood, about this share of the pixels would be painted wrong.</summary>
    private const double WrongShare = 0.25;

    private readonly SortedSet<(double Priority, MapCell Cell)> _cells = new(Comparer<(double Priority, MapCell Cell)>.Create(Compare));

    public int Count => _cells.Count;

    public IEnumerable<(double Priority, MapCell Cell)> Cells => _cells;

    public void Add(double priority, MapCell cell) => _cells.Add((priority, cell));

    public (double Priority, MapCell Cell) Take()
    {
        (double Priority, MapCell Cell) first = _cells.Min;
        _cells.Remove(first);
        return first;
    }

    private static int Compare((double Priority, MapCell Cell) a, (double Priority, MapCell Cell) b)
    {
        int byPriority = b.Priority.CompareTo(a.Priority);
        if (byPriority != 0)
        {
            return byPriority;
        }

        int byRow = a.Cell.Top.CompareTo(b.Cell.Top);
        int byColumn = a.Cell.Left.CompareTo(b.Cell.Left);
        return byRow != 0 ? byRow : byColumn != 0 ? byColumn : b.Cell.BorderLength.CompareTo(a.Cell.BorderLength);
    }

    /// <summary>How much a cell counts that is not understood.</summary>
    /// <param name="cell">The cell.</param>
    /// <param name="weight">What one wrong pixel in it counts.</param>
    public static double PriorityOf(MapCell cell, double weight) => WrongShare * cell.Width * cell.Height * weight;
}
