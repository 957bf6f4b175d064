namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// A rectangle of pixels between four corner pixels, inclusive. Neighbouring cells share the pixels of their common side.
/// </summary>
internal readonly record struct MapCell(int Left, int Top, int Right, int Bottom)
{
    public int Width => Right - Left;

    public int Height => Bottom - Top;

    /// <summary>Whether it has pixels that are not on its border.</summary>
    public bool HasInterior => Width > 1 && Height > 1;

    /// <summary>Number of pixels on its border; 1 for a cell of one pixel.</summary>
    public int BorderLength => Math.Max(1, 2 * (Width + Height));

    /// <summary>Whether a pixel is inside it or on its border.</summary>
    public bool Contains(int column, int row) => column >= Left && column <= Right && row >= Top && row <= Bottom;

    /// <summary>The cell's four parts, which share its middle column and row.</summary>
    public IEnumerable<MapCell> Quarters()
    {
        int column = (Left + Right) / 2;
        int row = (Top + Bottom) / 2;
        yield return new MapCell(Left, Top, column, row);
        yield return new MapCell(column, Top, Right, row);
        yield return new MapCell(Left, row, column, Bottom);
        yield return new MapCell(column, row, Right, Bottom);
    }

    /// <summary>The steps of the walk around the border at the middles of the sides, where the parts' corners are.</summary>
    public IEnumerable<int> SideMiddles()
    {
        yield return Width / 2;
        yield return Width + (Height / 2);
        yield return (2 * Width) + Height - (Width / 2);
        yield return (2 * Width) + (2 * Height) - (Height / 2);
    }

    /// <summary>The step of the walk around the border at a corner; the fifth is the first again, a walk later.</summary>
    public int Corner(int number) =>
        number switch
        {
            0 => 0,
            1 => Width,
            2 => Width + Height,
            3 => (2 * Width) + Height,
            _ => BorderLength,
        };

    /// <summary>The pixel at a step of a walk around the border, clockwise on the screen from the upper left corner.</summary>
    public (int Column, int Row) Border(int step)
    {
        if (step <= Width)
        {
            return (Left + step, Top);
        }

        if (step <= Width + Height)
        {
            return (Right, Top + step - Width);
        }

        return step <= (2 * Width) + Height ? (Right - (step - Width - Height), Bottom) : (Left, Bottom - (step - (2 * Width) - Height));
    }
}
