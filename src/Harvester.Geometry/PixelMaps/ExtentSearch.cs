namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Verifies the box around an object's visible pixels, side by side. Beyond each side, the object is searched for where it would continue
/// as a strip, and farther out where nothing nearer hides it; a side that no ray has confirmed is uncertain.
/// </summary>
internal sealed class ExtentSearch(IReadOnlyList<TargetView> views, PixelSamples samples, HiddenPlaces hiddenPlaces)
{
    /// <summary>Minimum number of visible pixels of an object whose extent is searched; smaller objects are only found.</summary>
    private const int MinPixels = 64;

    /// <summary>Tolerance of a box, pixels.</summary>
    private const int Tolerance = 2;

    /// <summary>Ratio of the distances of successive points.</summary>
    private const int Spread = 2;

    /// <summary>
    /// Beyond a side of at most this many pixels, the object may continue diagonally past its ends; a sloping arm moves this far aside over
    /// its head.
    /// </summary>
    private const int ShortSide = 3;

    private static readonly (int Column, int Row)[] Outwards = [(0, -1), (1, 0), (0, 1), (-1, 0)];

    /// <summary>The points to sample. Each depends on what was found at those before, so they must be enumerated lazily.</summary>
    /// <param name="map">The map so far.</param>
    public IEnumerable<SubpixelPoint> Places(InstanceMap map)
    {
        foreach (TargetView view in views)
        {
            if (ExtentOf(map, view) is not { } extent)
            {
                continue;
            }

            foreach ((int Column, int Row) outwards in Outwards)
            {
                foreach (SubpixelPoint place in Beyond(map, view, extent, outwards))
                {
                    yield return place;
                }
            }
        }
    }

    /// <summary>Pixels drawn at the sides of objects' boxes where no ray has hit the object on that side.</summary>
    public HashSet<(int Column, int Row)> UncertainPixels(InstanceMap map)
    {
        var uncertain = new HashSet<(int, int)>();
        foreach (TargetView view in views)
        {
            if (ExtentOf(map, view) is not { } extent)
            {
                continue;
            }

            foreach ((int Column, int Row) outwards in Outwards)
            {
                List<(int Column, int Row)> side = extent.Side(map, view.Target.Number, outwards);
                if (!side.Exists(pixel => samples.IsCast(pixel.Column, pixel.Row)))
                {
                    uncertain.UnionWith(side);
                }
            }
        }

        return uncertain;
    }

    private static PixelExtent? ExtentOf(InstanceMap map, TargetView view) =>
        PixelExtent.Of(map, view.Target.Number, view.Spans) is { Pixels: >= MinPixels } extent ? extent : null;

    private IEnumerable<SubpixelPoint> Beyond(InstanceMap map, TargetView view, PixelExtent extent, (int Column, int Row) outwards)
    {
        List<(int Column, int Row)> side = extent.Side(map, view.Target.Number, outwards);
        (int Column, int Row) deepest = Deepest(map, side, outwards);
        int room = PixelExtent.Room(view.Spans, deepest, outwards);
        while (room > Tolerance)
        {
            (int Column, int Row)? found = null;
            foreach ((int Column, int Row) pixel in Near(side, deepest, outwards).Concat(Far(map, view, side, deepest, outwards, room)))
            {
                if (view.Spans.Contains(pixel.Column, pixel.Row))
                {
                    yield return SubpixelPoint.OfPixel(pixel.Column, pixel.Row);
                    if (Shows(view, pixel))
                    {
                        found = pixel;
                        break;
                    }
                }
            }

            if (found is not { } farther)
            {
                yield break;
            }

            (side, deepest) = ([farther], farther);
            room = PixelExtent.Room(view.Spans, deepest, outwards);
        }
    }

    // A strip continues straight or diagonally outwards: beside the ends of a short side, and of a long one where the object reaches
    // farthest inwards.
    private static IEnumerable<(int Column, int Row)> Near(
        List<(int Column, int Row)> side,
        (int Column, int Row) deepest,
        (int Column, int Row) outwards
    )
    {
        yield return Moved(deepest, outwards, Tolerance, 0);
        if (side.Count <= ShortSide)
        {
            yield return Moved(side[0], outwards, Tolerance, -1);
            yield return Moved(side[side.Count - 1], outwards, Tolerance, 1);
            yield break;
        }

        for (int aside = 1; aside <= ShortSide; aside++)
        {
            yield return Moved(deepest, outwards, Tolerance, -aside);
            yield return Moved(deepest, outwards, Tolerance, aside);
        }
    }

    private IEnumerable<(int Column, int Row)> Far(
        InstanceMap map,
        TargetView view,
        List<(int Column, int Row)> side,
        (int Column, int Row) deepest,
        (int Column, int Row) outwards,
        int room
    )
    {
        foreach ((int Column, int Row) from in new[] { deepest, side[side.Count / 2] }.Distinct())
        {
            for (int away = Spread * Tolerance; away <= room; away++)
            {
                (int Column, int Row) pixel = Moved(from, outwards, away, 0);
                if (!IsHiddenByObject(view, map, pixel.Column, pixel.Row))
                {
                    yield return pixel;

                    // Distances of 4, 8, 16, ... pixels, and the whole room last, so that a gap is bridged in a logarithm of it.
                    away = (away < room && Spread * away > room ? room : Spread * away) - 1;
                }
            }
        }
    }

    private static (int Column, int Row) Moved((int Column, int Row) from, (int Column, int Row) outwards, int away, int aside) =>
        (
            from.Column + (away * outwards.Column) + (aside * Math.Abs(outwards.Row)),
            from.Row + (away * outwards.Row) + (aside * Math.Abs(outwards.Column))
        );

    // Parts of the world lie nearer and farther everywhere, above all on the ground around a foot.
    private bool IsHiddenByObject(TargetView view, InstanceMap map, int column, int row) =>
        map[column, row] != 0 && hiddenPlaces.IsHidden(view.Target, map, column, row);

    // An arm continues where the object reaches farthest inwards, not where its head is wide.
    private static (int Column, int Row) Deepest(InstanceMap map, List<(int Column, int Row)> side, (int Column, int Row) outwards)
    {
        (int Column, int Row) deepest = side[side.Count / 2];
        int depth = DepthOf(map, deepest, outwards);
        foreach ((int Column, int Row) pixel in side)
        {
            int other = DepthOf(map, pixel, outwards);
            if (other > depth)
            {
                (deepest, depth) = (pixel, other);
            }
        }

        return deepest;
    }

    private static int DepthOf(InstanceMap map, (int Column, int Row) from, (int Column, int Row) outwards)
    {
        ushort number = map[from.Column, from.Row];
        int depth = 0;
        (int column, int row) = from;
        while (column >= 0 && row >= 0 && column < map.Image.Width && row < map.Image.Height && map[column, row] == number)
        {
            depth++;
            (column, row) = (column - outwards.Column, row - outwards.Row);
        }

        return depth;
    }

    private bool Shows(TargetView view, (int Column, int Row) pixel) =>
        samples.IsCast(pixel.Column, pixel.Row) && samples.Number(pixel.Column, pixel.Row) == view.Target.Number;
}
