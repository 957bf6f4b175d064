using System.Numerics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A set of tiles of a shadow map, which has 64 rows of 64 tiles. Several threads may add tiles at once; everything else is for one thread.
/// </summary>
/// <param name="size">Rows and columns of the map, texels; a multiple of 64 and a power of two.</param>
internal sealed class ShadowTiles(int size)
{
    private const int Across = 64;
    private readonly ulong[] _rows = new ulong[Across];
    private readonly int _shift = BitOperations.Log2((uint)(size / Across));

    /// <summary>Whether the set has no tile.</summary>
    public bool IsEmpty => !_rows.AsSpan().ContainsAnyExcept(0UL);

    public void Clear() => Array.Clear(_rows);

    public void AddAll() => Array.Fill(_rows, ulong.MaxValue);

    /// <summary>Adds the tiles of a texel and of the next ones to the right, above, and both.</summary>
    /// <param name="texel">Number of the texel, row by row; it is in neither the last row nor the last column.</param>
    public void AddAround(int texel)
    {
        int column = texel & (size - 1);
        int row = texel / size;
        ulong columns = (1UL << (column >> _shift)) | (1UL << ((column + 1) >> _shift));
        Add(row >> _shift, columns);
        Add((row + 1) >> _shift, columns);
    }

    /// <summary>Adds the tiles of another set of the same size.</summary>
    public void Add(ShadowTiles others)
    {
        for (int row = 0; row < Across; row++)
        {
            _rows[row] |= others._rows[row];
        }
    }

    /// <summary>Becomes the tiles of one set that another has not.</summary>
    /// <returns>Whether there are any.</returns>
    public bool TakeMissing(ShadowTiles wanted, ShadowTiles present)
    {
        ulong any = 0;
        for (int row = 0; row < Across; row++)
        {
            _rows[row] = wanted._rows[row] & ~present._rows[row];
            any |= _rows[row];
        }

        return any != 0;
    }

    /// <summary>The columns of tiles that a row of texels has, as bits from the lowest.</summary>
    /// <param name="row">A row of texels.</param>
    public ulong ColumnsAt(int row) => _rows[row >> _shift];

    /// <summary>The columns of tiles that texels lie in, as bits from the lowest.</summary>
    /// <param name="left">The first texel.</param>
    /// <param name="right">The texel after the last one, greater than the first.</param>
    public ulong ColumnsOf(int left, int right)
    {
        int first = left >> _shift;
        int last = (right - 1) >> _shift;
        return (ulong.MaxValue << first) & (ulong.MaxValue >> (Across - 1 - last));
    }

    /// <summary>Whether a rectangle of texels [left, right) x [bottom, top), which is not empty, reaches into a tile of the set.</summary>
    public bool HasAnyIn(int left, int bottom, int right, int top)
    {
        ulong columns = ColumnsOf(left, right);
        int last = (top - 1) >> _shift;
        for (int row = bottom >> _shift; row <= last; row++)
        {
            if ((_rows[row] & columns) != 0)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Takes the first stretch of neighbouring columns of tiles out of some.</summary>
    /// <param name="columns">Columns of tiles as bits, not 0.</param>
    /// <returns>The texels [Left, Right) of the stretch.</returns>
    public (int Left, int Right) TakeStretch(ref ulong columns)
    {
        int first = BitOperations.TrailingZeroCount(columns);
        int end = first + BitOperations.TrailingZeroCount(~(columns >> first));
        columns = end < Across ? columns & (ulong.MaxValue << end) : 0;
        return (first << _shift, Math.Min(end, Across) << _shift);
    }

    private void Add(int row, ulong columns)
    {
        if ((Volatile.Read(ref _rows[row]) & columns) != columns)
        {
            Interlocked.Or(ref _rows[row], columns);
        }
    }
}
