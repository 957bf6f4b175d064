using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Masks.Pixels;

/// <summary>
/// The outlines of a mask as polygons along pixel borders, in continuous pixel coordinates. Pixels that touch only at a corner are not
/// connected.
/// </summary>
internal static class MaskOutlines
{
    // Clockwise on the screen with the object on the right: right along its upper side, down its right side, and so on.
    private static readonly (int X, int Y)[] Steps = [(1, 0), (0, 1), (-1, 0), (0, -1)];

    /// <summary>Traces the outlines of one object.</summary>
    /// <param name="map">The map.</param>
    /// <param name="number">Value of the object; 1 or more.</param>
    /// <returns>Closed polygons without a repeated last corner: outer outlines clockwise on the screen, outlines of holes
    /// counter-clockwise. The areas, negative for holes, add up to the number of pixels. Empty if there are none.</returns>
    public static IReadOnlyList<IReadOnlyList<Vector2D>> Of(InstanceMap map, ushort number)
    {
        var outlines = new List<IReadOnlyList<Vector2D>>();
        var followed = new HashSet<(int Column, int Row, int Side)>();
        for (int row = 0; row < map.Image.Height; row++)
        {
            for (int column = 0; column < map.Image.Width; column++)
            {
                // Every outline has an upper side; for a hole, it is the upper side of the pixel below.
                if (Shows(map, number, column, row) && !Shows(map, number, column, row - 1) && !followed.Contains((column, row, 0)))
                {
                    outlines.Add(Follow(map, number, column, row, followed));
                }
            }
        }

        return outlines;
    }

    private static List<Vector2D> Follow(
        InstanceMap map,
        ushort number,
        int column,
        int row,
        HashSet<(int Column, int Row, int Side)> followed
    )
    {
        var corners = new List<Vector2D>();
        int side = 0;
        while (followed.Add((column, row, side)))
        {
            (int ahead, int outward) = (side, (side + 3) % 4);
            (int X, int Y) next = (column + Steps[ahead].X, row + Steps[ahead].Y);
            (int X, int Y) beyond = (next.X + Steps[outward].X, next.Y + Steps[outward].Y);
            if (!Shows(map, number, next.X, next.Y))
            {
                corners.Add(EndOf(column, row, side));
                side = (side + 1) % 4;
            }
            else if (Shows(map, number, beyond.X, beyond.Y))
            {
                corners.Add(EndOf(column, row, side));
                (column, row) = beyond;
                side = outward;
            }
            else
            {
                (column, row) = next;
            }
        }

        return corners;
    }

    // The end of a pixel's side when traversed clockwise.
    private static Vector2D EndOf(int column, int row, int side) => new(column + (side is 0 or 1 ? 1 : 0), row + (side is 1 or 2 ? 1 : 0));

    private static bool Shows(InstanceMap map, ushort number, int column, int row) =>
        map.Image.Contains(column, row) && map[column, row] == number;
}
