using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// An order of the pixels in which the first of them, however many, are scattered evenly: of those that rank below 1/2^k, exactly one lies
/// in each rectangle of 2^k pixels whose sides are powers of 2 and that is aligned to multiples of them, even if it is a single row or
/// column.
/// </summary>
/// <remarks>
/// The inverse of the Sobol sequence (1967) in its first two dimensions, a digital net in base 2: the number of the point in a pixel. Its
/// dimensions are the bit reversal and Pascal's triangle modulo 2. Columns are mixed first, since otherwise diagonals would be empty.
/// </remarks>
internal sealed class ScatteredRank
{
    private const int Bits = 16;

    /// <summary>
    /// A digital shift by the bits 0101...: the first pixels lie a third of the way into a cell. Without it they would be corners of cells
    /// and middles of their sides, which are known anyway.
    /// </summary>
    private const int Shift = 0x5555;

    private readonly int[] _columns;
    private readonly int[] _rows;

    public ScatteredRank(ImageSize image)
    {
        _columns = new int[image.Width];
        for (int column = 0; column < _columns.Length; column++)
        {
            _columns[column] = Reversed(column ^ (column >> 1) ^ (column >> 3)) ^ Shift;
        }

        _rows = new int[image.Height];
        for (int row = 0; row < _rows.Length; row++)
        {
            _rows[row] = Pascal(Reversed(row));
        }
    }

    /// <summary>The rank of a pixel, at least 0 and below 1.</summary>
    public double Of(int column, int row) => (double)(_columns[column] ^ _rows[row]) / (1 << Bits);

    private static int Reversed(int value)
    {
        int reversed = 0;
        for (int bit = 0; bit < Bits; bit++)
        {
            reversed |= ((value >> bit) & 1) << (Bits - 1 - bit);
        }

        return reversed;
    }

    // Each bit becomes the sum of those whose indices contain the bits of its own index.
    private static int Pascal(int value)
    {
        for (int step = 1; step < Bits; step *= 2)
        {
            for (int bit = 0; bit < Bits; bit++)
            {
                if ((bit & step) == 0)
                {
                    value ^= ((value >> (bit | step)) & 1) << bit;
                }
            }
        }

        return value;
    }
}
