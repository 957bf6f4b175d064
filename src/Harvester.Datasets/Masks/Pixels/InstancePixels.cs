using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Masks.Pixels;

/// <summary>The pixels of one object in an instance mask.</summary>
/// <param name="Map">The mask.</param>
/// <param name="Id">The object's value in the mask.</param>
/// <param name="Left">First column.</param>
/// <param name="Top">First row.</param>
/// <param name="Right">Column after the last.</param>
/// <param name="Bottom">Row after the last.</param>
/// <param name="Area">Number of pixels.</param>
internal sealed record InstancePixels(InstanceMap Map, ushort Id, int Left, int Top, int Right, int Bottom, int Area)
{
    /// <summary>The box around the pixels.</summary>
    public Box2D Box => new(Left, Top, Right, Bottom);

    /// <summary>
    /// A closed polygon for each connected region, the largest first. It passes around the holes of its region over a segment that is
    /// traversed in both directions, so that by the even-odd rule it covers exactly the pixels of the region.
    /// </summary>
    public IReadOnlyList<IReadOnlyList<Vector2D>> Regions()
    {
        IReadOnlyList<Vector2D>[] all = [.. MaskOutlines.Of(Map, Id).OrderByDescending(SignedArea)];
        IReadOnlyList<Vector2D>[] outer = [.. all.Where(outline => SignedArea(outline) > 0)];
        ILookup<IReadOnlyList<Vector2D>, IReadOnlyList<Vector2D>> holes = all.Skip(outer.Length)
            .ToLookup(hole => outer.Last(region => Contains(region, BesideStart(hole))));
        return [.. outer.Select(region => JoinedOutline.Of([region, .. holes[region]]))];
    }

    /// <summary>A single closed polygon around all regions and holes, which covers exactly the pixels by the even-odd rule.</summary>
    public IReadOnlyList<Vector2D> Contour() => JoinedOutline.Of([.. MaskOutlines.Of(Map, Id).OrderByDescending(SignedArea)]);

    /// <summary>All objects of a mask by id, found in one pass.</summary>
    public static IReadOnlyDictionary<int, InstancePixels> AllOf(InstanceMap map)
    {
        var found = new Dictionary<int, InstancePixels>();
        int width = map.Image.Width;
        for (int row = 0; row < map.Image.Height; row++)
        {
            ReadOnlySpan<ushort> ids = map.Ids.AsSpan(row * width, width);
            for (int column = 0; column < width; )
            {
                ushort id = ids[column];
                int length = ids[column..].IndexOfAnyExcept(id);
                int end = length < 0 ? width : column + length;

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

    /// <summary>The middle of the object's pixel at the first side of an outline, which has the object on its right.</summary>
    private static Vector2D BesideStart(IReadOnlyList<Vector2D> outline)
    {
        Vector2D way = outline[1] - outline[0];
        Vector2D half = way * (0.5 / way.Length);
        return outline[0] + half + new Vector2D(-half.Y, half.X);
    }

    /// <summary>The even-odd rule: whether a ray to the right crosses an odd number of sides.</summary>
    private static bool Contains(IReadOnlyList<Vector2D> outline, Vector2D point)
    {
        bool isInside = false;
        for (int i = 0; i < outline.Count; i++)
        {
            (Vector2D a, Vector2D b) = (outline[i], outline[(i + 1) % outline.Count]);
            isInside ^= a.Y > point.Y != b.Y > point.Y && a.X > point.X;
        }

        return isInside;
    }

    /// <summary>The area of a polygon, positive if it is clockwise in the image.</summary>
    private static double SignedArea(IReadOnlyList<Vector2D> outline) =>
        outline
            .Select((corner, i) => (Corner: corner, Next: outline[(i + 1) % outline.Count]))
            .Sum(side => (side.Corner.X * side.Next.Y) - (side.Next.X * side.Corner.Y)) / 2;

    private InstancePixels With(int left, int right, int row) =>
        this with
        {
            Left = left < Left ? left : Left,
            Right = right > Right ? right : Right,
            Bottom = row + 1,
            Area = Area + right - left,
        };
}
