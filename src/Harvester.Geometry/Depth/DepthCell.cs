namespace Harvester.Geometry.Depth;

/// <summary>A rectangle of pixels whose corners are sampled; neighbours share their borders.</summary>
/// <param name="Left">First column.</param>
/// <param name="Top">First row.</param>
/// <param name="Right">Last column, shared with the next cell.</param>
/// <param name="Bottom">Last row, shared with the cell below.</param>
internal readonly record struct DepthCell(int Left, int Top, int Right, int Bottom)
{
    /// <summary>The longer side, pixels.</summary>
    public int Side => System.Math.Max(Right - Left, Bottom - Top);

    /// <summary>The corners by column and row.</summary>
    public (int Column, int Row)[] Corners => [(Left, Top), (Right, Top), (Left, Bottom), (Right, Bottom)];

    /// <summary>The pixel in the middle.</summary>
    public (int Column, int Row) Middle => ((Left + Right) / 2, (Top + Bottom) / 2);

    /// <summary>The cell divided at a column and a row; not divided at those of its border.</summary>
    public IEnumerable<DepthCell> Parts(int column, int row)
    {
        int[] columns = column > Left ? [Left, column, Right] : [Left, Right];
        int[] rows = row > Top ? [Top, row, Bottom] : [Top, Bottom];
        for (int y = 0; y + 1 < rows.Length; y++)
        {
            for (int x = 0; x + 1 < columns.Length; x++)
            {
                yield return new DepthCell(columns[x], rows[y], columns[x + 1], rows[y + 1]);
            }
        }
    }
}
