namespace Harvester.Geometry.Maps;

/// <summary>Finds things by where they are on the ground: square cells, each with the things whose box meets it.</summary>
/// <param name="cell">Side of a cell, metres.</param>
internal sealed class GroundGrid<T>(double cell)
{
    /// <summary>A thing that meets more cells is in none, and found everywhere.</summary>
    private const double MaxCells = 256;

    /// <summary>Things farther than this many cells from the origin are in no cell, and found everywhere.</summary>
    private const double MaxCell = 1e12;

    private readonly Dictionary<(long X, long Y), List<T>> _cells = [];
    private readonly List<T> _large = [];

    /// <summary>Adds a thing that lies within a box.</summary>
    public void Add(T thing, Box2D box)
    {
        if (!(Cells(box) <= MaxCells))
        {
            _large.Add(thing);
            return;
        }

        for (long x = CellOf(box.XMin); x <= CellOf(box.XMax); x++)
        {
            for (long y = CellOf(box.YMin); y <= CellOf(box.YMax); y++)
            {
                if (!_cells.TryGetValue((x, y), out List<T>? things))
                {
                    _cells.Add((x, y), things = []);
                }

                things.Add(thing);
            }
        }
    }

    /// <summary>Everything whose box comes within a distance of a place, and possibly some that is farther away; each thing once, in an
    /// order that depends on what was added and the place alone.</summary>
    public IEnumerable<T> Near(double x, double y, double range)
    {
        var box = new Box2D(x - range, y - range, x + range, y + range);
        IEnumerable<List<T>> cells = Cells(box) <= MaxCells ? CellsIn(box) : _cells.Values;
        return _large.Concat(cells.SelectMany(static things => things)).Distinct();
    }

    private IEnumerable<List<T>> CellsIn(Box2D box)
    {
        for (long x = CellOf(box.XMin); x <= CellOf(box.XMax); x++)
        {
            for (long y = CellOf(box.YMin); y <= CellOf(box.YMax); y++)
            {
                if (_cells.TryGetValue((x, y), out List<T>? things))
                {
                    yield return things;
                }
            }
        }
    }

    private double Cells(Box2D box)
    {
        double farthest = Math.Max(Math.Max(Math.Abs(box.XMin), Math.Abs(box.XMax)), Math.Max(Math.Abs(box.YMin), Math.Abs(box.YMax)));
        return farthest / cell <= MaxCell ? ((box.Width / cell) + 1) * ((box.Height / cell) + 1) : double.PositiveInfinity;
    }

    private long CellOf(double place) => (long)Math.Floor(place / cell);
}
