using System;
using System.Collections.Generic;
using Harvester.Geometry;

namespace Harvester.Simulation.Traffic;

/// <summary>Finds bodies near a position by a grid on the ground.</summary>
/// <typeparam name="T">The bodies.</typeparam>
internal sealed class BodyIndex<T>
    where T : notnull
{
    private const double CellSize = 20;

    private readonly Dictionary<long, List<T>> _cells = [];

    public bool IsEmpty => _cells.Count == 0;

    public void Add(T body, Vector3D place)
    {
        long cell = Key(CellOf(place));
        if (!_cells.TryGetValue(cell, out List<T>? list))
        {
            _cells[cell] = list = [];
        }

        list.Add(body);
    }

    public void Move(T body, Vector3D from, Vector3D to)
    {
        if (CellOf(from) != CellOf(to))
        {
            _cells[Key(CellOf(from))].Remove(body);
            Add(body, to);
        }
    }

    /// <summary>The bodies of the cell at a position and of the eight around it: all within 20 m, and some farther away.</summary>
    public IEnumerable<T> Near(Vector3D place)
    {
        (int x, int y) = CellOf(place);
        for (int i = x - 1; i <= x + 1; i++)
        {
            for (int j = y - 1; j <= y + 1; j++)
            {
                if (_cells.TryGetValue(Key((i, j)), out List<T>? cell))
                {
                    foreach (T body in cell)
                    {
                        yield return body;
                    }
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
        (int x, int y) = CellOf(place);
        for (int i = x - 1; i <= x + 1; i++)
        {
            for (int j = y - 1; j <= y + 1; j++)
            {
                if (_cells.TryGetValue(Key((i, j)), out List<T>? cell))
                {
                    foreach (T body in cell)
                    {
                        if (condition(body, asked))
                        {
                            return true;
                        }
                    }
                }
            }
        }

        return false;
    }

    private static (int X, int Y) CellOf(Vector3D place) => ((int)Math.Floor(place.X / CellSize), (int)Math.Floor(place.Y / CellSize));

    /// <summary>A cell as one number, which is hashed faster than a pair.</summary>
    private static long Key((int X, int Y) cell) => ((long)cell.X << 32) | (uint)cell.Y;
}
