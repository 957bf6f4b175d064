namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Cells in the order of the weight of their error, greatest first; equal ones by position, so that the order is deterministic.
/// </summary>
internal sealed class CellQueue
{
    /// <summary>Estimated fraction of wrong pixels in an unresolved cell.</summary>
    private const double WrongFraction = 0.25;

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
        return byRow != 0 ? byRow
            : byColumn != 0 ? byColumn
            : b.Cell.BorderLength.CompareTo(a.Cell.BorderLength);
    }

    /// <summary>The priority of an unresolved cell.</summary>
    /// <param name="cell">The cell.</param>
    /// <param name="weight">The weight of one wrong pixel in it.</param>
    public static double PriorityOf(MapCell cell, double weight) => WrongFraction * cell.Width * cell.Height * weight;
}
