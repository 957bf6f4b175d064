namespace Harvester.Geometry.ClassMaps;

/// <summary>A rectangle of pixels whose corners are sampled; neighbours share their borders.</summary>
/// <param name="Left">First column.</param>
/// <param name="Top">First row.</param>
/// <param name="Right">Last column, shared with the next cell.</param>
/// <param name="Bottom">Last row, shared with the cell below.</param>
internal readonly record struct ClassCell(int Left, int Top, int Right, int Bottom)
{
    /// <summary>The longer side, pixels.</summary>
    public int Side => System.Math.Max(Right - Left, Bottom - Top);

    /// <summary>Whether a pixel is in the cell, borders included.</summary>
    public bool Contains(int column, int row) => column >= Left && column <= Right && row >= Top && row <= Bottom;
}
