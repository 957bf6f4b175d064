using Harvester.Geometry;

namespace Harvester.Simulation.Traffic;

/// <summary>Finds bodies near a position by a grid on the ground.</summary>
/// <typeparam name="T">The bodies.</typeparam>
internal sealed class BodyIndex<T>
    where T : notnull
{
    private const double CellSize = 20;

    private readonly Dictionary<long, Cell> _cells = [];
    private int _count;

    public bool IsEmpty => _count == 0;

    public void Add(T body, Vector3D place)
    {
        CellAt(CellOf(place)).Bodies.Add(body);
        _count++;
    }

    /// <summary>Removes all bodies, but keeps their cells for others.</summary>
    public void Clear()
    {
        if (!IsEmpty)
        {
            foreach (Cell cell in _cells.Values)
            {
                cell.Bodies.Clear();
            }

            _count = 0;
        }
    }

    /// <summary>Removes a body that stands at a position.</summary>
    public void Remove(T body, Vector3D place)
    {
        if (Find(CellOf(place)) is { } cell && cell.Bodies.Remove(body))
        {
            _count--;
        }
    }

    public void Move(T body, Vector3D from, Vector3D to)
    {
        if (CellOf(from) != CellOf(to))
        {
            _cells[Key(CellOf(from))].Bodies.Remove(body);
            CellAt(CellOf(to)).Bodies.Add(body);
        }
    }

    /// <summary>The bodies of the cell at a position and of the eight around it: all within 20 m, and some farther away.</summary>
    public IEnumerable<T> Near(Vector3D place)
    {
        (int X, int Y) middle = CellOf(place);
        Cell?[]? around = AroundKnown(middle);
        for (int number = 0; number < Cell.Neighbours; number++)
        {
            if ((around is null ? Find(Cell.Neighbour(middle, number)) : around[number]) is { } cell)
            {
                foreach (T body in cell.Bodies)
                {
                    yield return body;
                }
            }
        }
    }

    /// <summary>
    /// Whether a condition holds for one of these bodies. Called for every vehicle in every tick, so it allocates nothing.
    /// </summary>
    /// <param name="place">The position.</param>
    /// <param name="asked">The argument of the condition.</param>
    /// <param name="condition">A condition on a body and the argument.</param>
    public bool AnyNear<TAsked>(Vector3D place, in TAsked asked, Func<T, TAsked, bool> condition)
    {
        if (IsEmpty)
        {
            return false;
        }

        (int X, int Y) middle = CellOf(place);
        Cell?[]? around = AroundKnown(middle);
        for (int number = 0; number < Cell.Neighbours; number++)
        {
            if ((around is null ? Find(Cell.Neighbour(middle, number)) : around[number]) is { } cell)
            {
                foreach (T body in cell.Bodies)
                {
                    if (condition(body, asked))
                    {
                        return true;
                    }
                }
            }
        }

        return false;
    }

    private static (int X, int Y) CellOf(Vector3D place) => ((int)Math.Floor(place.X / CellSize), (int)Math.Floor(place.Y / CellSize));

    /// <summary>A cell as one number, which is hashed faster than a pair.</summary>
    private static long Key((int X, int Y) cell) => ((long)cell.X << 32) | (uint)cell.Y;

    private Cell? Find((int X, int Y) place) => _cells.GetValueOrDefault(Key(place));

    /// <summary>The cells around a cell; null if nothing was ever in that, so that its neighbours must be looked up.</summary>
    private Cell?[]? AroundKnown((int X, int Y) middle) => Find(middle)?.Around;

    private Cell CellAt((int X, int Y) place)
    {
        if (Find(place) is { } known)
        {
            return known;
        }

        var cell = new Cell();
        _cells.Add(Key(place), cell);
        for (int number = 0; number < Cell.Neighbours; number++)
        {
            if (Find(Cell.Neighbour(place, number)) is { } neighbour)
            {
                cell.Around[number] = neighbour;
                neighbour.Around[Cell.Neighbours - 1 - number] = cell;
            }
        }

        return cell;
    }

    private sealed class Cell
    {
        /// <summary>The cell itself and the eight around it.</summary>
        public const int Neighbours = 9;

        private const int Across = 3;

        public List<T> Bodies { get; } = [];

        /// <summary>By number: column by column, each from the south. The cell itself stands in the middle.</summary>
        public Cell?[] Around { get; } = new Cell?[Neighbours];

        public static (int X, int Y) Neighbour((int X, int Y) middle, int number) =>
            (middle.X - 1 + (number / Across), middle.Y - 1 + (number % Across));
    }
}
