namespace Harvester.Geometry.PixelMaps;

/// <summary>The range of columns and rows in which a map shows an object, inclusive.</summary>
/// <param name="Left">First column.</param>
/// <param name="Top">First row.</param>
/// <param name="Right">Last column.</param>
/// <param name="Bottom">Last row.</param>
/// <param name="Pixels">Number of its pixels.</param>
internal readonly record struct PixelExtent(int Left, int Top, int Right, int Bottom, int Pixels)
{
    /// <summary>The extent of a number; null if no pixel shows it.</summary>
    /// <param name="map">The map.</param>
    /// <param name="number">The number.</param>
    /// <param name="within">Its silhouette; pixels outside its box are not searched.</param>
    public static PixelExtent? Of(InstanceMap map, ushort number, SilhouetteSpans within)
    {
        PixelExtent? extent = null;
        for (int row = within.FirstRow; row <= within.LastRow; row++)
        {
            for (int column = within.FirstColumn; column <= within.LastColumn; column++)
            {
                if (map[column, row] == number)
                {
                    extent = extent is { } known
                        ? new PixelExtent(Math.Min(known.Left, column), known.Top, Math.Max(known.Right, column), row, known.Pixels + 1)
                        : new PixelExtent(column, row, column, row, 1);
                }
            }
        }

        return extent;
    }

    /// <summary>Distance in pixels from a pixel to the end of a silhouette's box in a direction along rows or columns.</summary>
    public static int Room(SilhouetteSpans within, (int Column, int Row) from, (int Column, int Row) outwards) =>
        outwards switch
        {
            (0, < 0) => from.Row - within.FirstRow,
            (0, _) => within.LastRow - from.Row,
            (< 0, _) => from.Column - within.FirstColumn,
            _ => within.LastColumn - from.Column,
        };

    /// <summary>The object's pixels on one side of the extent, in order; the direction is along rows or columns.</summary>
    public List<(int Column, int Row)> Side(InstanceMap map, ushort number, (int Column, int Row) outwards)
    {
        (int left, int top, int right, int bottom) = outwards switch
        {
            (0, < 0) => (Left, Top, Right, Top),
            (0, _) => (Left, Bottom, Right, Bottom),
            (< 0, _) => (Left, Top, Left, Bottom),
            _ => (Right, Top, Right, Bottom),
        };
        var side = new List<(int, int)>();
        for (int row = top; row <= bottom; row++)
        {
            for (int column = left; column <= right; column++)
            {
                if (map[column, row] == number)
                {
                    side.Add((column, row));
                }
            }
        }

        return side;
    }
}
