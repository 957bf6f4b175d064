using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Masks.Pixels;

/// <summary>The pixels of one object in an instance mask.</summary>
/// <param name="Map">The mask.</param>
/// <param name="Id">The object's value in it.</param>
/// <param name="Left">First column with a pixel of it.</param>
/// <param name="Top">First row.</param>
/// <param name="Right">Column after the last.</param>
/// <param name="Bottom">Row after the last.</param>
/// <param name="Area">Number of its pixels.</param>
internal sealed record InstancePixels(InstanceMap Map, ushort Id, int Left, int Top, int Right, int Bottom, int Area)
{
    /// <summary>The box around the pixels.</summary>
    public Box2D Box => new(Left, Top, Right, Bottom);

    /// <summary>
    /// Outlines of its parts that hang together, the largest first; without those of holes, so that holes count as filled.
    /// </summary>
    public IReadOnlyList<IReadOnlyList<Vector2D>> Outlines() =>
        [.. MaskOutlines.Of(Map, Id).Where(outline => SignedArea(outline) > 0).OrderByDescending(SignedArea)];

    /// <summary>
    /// One closed polygon around all of its parts and along its holes, which covers exactly its pixels by the even-odd rule.
    /// </summary>
    public IReadOnlyList<Vector2D> Contour() => JoinedOutline.Of([.. MaskOutlines.Of(Map, Id).OrderByDescending(SignedArea)]);

    /// <summary>All objects of a mask by their id, found in one pass.</summary>
    public static IReadOnlyDictionary<int, InstancePixels> AllOf(InstanceMap map)
    {
        var found = new Dictionary<int, InstancePixels>();
        int width = map.Image.Width;
        for (int row = 0; row < map.Image.Height; row++)
        {
            for (int column = 0; column < width;)
            {
                ushort id = map[column, row];
                int end = column + 1;
                while (end < width && map[end, row] == id)
                {
                    end++;
                }

                if (id != 0)
                {
                    found[id] = found.TryGetValue(id, out InstancePixels? earlier)
                        ? earlier.With(column, end, row)
                        : new InstancePixels(map, id, column, row, end, row + 1, end - column);
                }

                column = end;
            }
        }

        return found;
    }

    /// <summary>The area of a polygon, positive when it runs clockwise as seen in the image.</summary>
    private static double SignedArea(IReadOnlyList<Vector2D> outline) => outline
        .Select((corner, i) => (Corner: corner, Next: outline[(i + 1) % outline.Count]))
        .Sum(side => (side.Corner.X * side.Next.Y) - (side.Next.X * side.Corner.Y)) / 2;

    private InstancePixels With(int left, int right, int row) => this with
    {
        Left = left < Left ? left : Left,
        Right = right > Right ? right : Right,
        Bottom = row + 1,
        Area = Area + right - left,
    };
}
