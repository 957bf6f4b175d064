namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// Settles the outline of an object to the pixel. A pixel at an edge mixes the colours on both sides. It is the object's if the object's
/// colour, as its neighbours inside show it, makes up half of it or more. Pixels that miss only because object and background look alike
/// are filled in where most neighbours are the object's. Faint fragments are dropped, and small holes are filled.
/// </summary>
internal sealed class EdgeSettler(PictureStack stack, NoiseMap noise, int imageWidth)
{
    private static readonly (int Across, int Down)[] Sides = [(-1, 0), (1, 0), (0, -1), (0, 1)];

    /// <summary>Two colours closer than this many standard deviations of the noise cannot be distinguished in a mixture.</summary>
    private const double MinContrast = 5;

    /// <summary>
    /// A pixel with a smaller share of the object than this is not the object's. It is under a half, because faces of an object differ in
    /// brightness, which looks like a smaller share.
    /// </summary>
    private const double MaxShare = 0.4;

    /// <summary>A colour farther from the line between both colours than this fraction of it is no mixture.</summary>
    private const double RimFraction = 0.08;
    private const double RestDeviations = 3;

    /// <summary>A pixel as close as this to the object's colour may be the object's.</summary>
    private const double FillDeviations = 4;
    private const int FillNeighbours = 5;
    private const int FillRounds = 12;

    private readonly FragmentFilter _fragments = new(noise, imageWidth);

    public void Settle(ObjectPlane plane)
    {
        // Fragments go first, so that they do not count as neighbours; filling comes after trimming, which it must not undo.
        _fragments.DropFaint(plane);
        TrimEdges(plane);
        for (int round = 0; round < FillRounds && Fill(plane); round++) { }

        FragmentFilter.FillHoles(plane);
        _fragments.FillLikes(plane, stack.Picture(0));
    }

    private static int NeighboursOf(ObjectPlane plane, int x, int y)
    {
        int count = 0;
        for (int v = y - 1; v <= y + 1; v++)
        {
            for (int u = x - 1; u <= x + 1; u++)
            {
                count += (u != x || v != y) && plane.Has(u, v) ? 1 : 0;
            }
        }

        return count;
    }

    private static bool IsInside(ObjectPlane plane, int x, int y) =>
        plane.Has(x, y) && plane.Has(x - 1, y) && plane.Has(x + 1, y) && plane.Has(x, y - 1) && plane.Has(x, y + 1);

    private void TrimEdges(ObjectPlane plane)
    {
        List<int> trimmed = [];
        for (int y = 0; y < plane.Height; y++)
        {
            for (int x = 0; x < plane.Width; x++)
            {
                if (plane.Has(x, y) && !IsInside(plane, x, y) && IsMostlyOther(plane, x, y))
                {
                    trimmed.Add((y * plane.Width) + x);
                }
            }
        }

        foreach (int index in trimmed)
        {
            plane.State[index] = PixelState.Edge;
        }
    }

    /// <summary>
    /// Whether a pixel at the edge is a mixture of the background and less than half of a neighbour. A pixel between two that show
    /// different things is mixed on one side of the border only, so the neighbour's colour is pure.
    /// </summary>
    private bool IsMostlyOther(ObjectPlane plane, int x, int y)
    {
        int index = (y * plane.Width) + x;
        Vector3D outside = OutsideOf(plane, x, y);

        // With outside o, pixel p and neighbour n, a mixture is p = o + share·(n - o). Least squares give
        // share = (p - o)·(n - o) / |n - o|², and the rest p - o - share·(n - o) is what no mixture explains.
        Vector3D over = plane.ColourAt(index) - outside;
        double variance = noise.At(PixelOf(plane, x, y)) / plane.Counts[2 * index];
        foreach ((int across, int down) in Sides)
        {
            // Only a side with the object on it and none of it opposite is an outline.
            if (plane.Has(x + across, y + down) && !plane.Has(x - across, y - down))
            {
                Vector3D span = plane.ColourAt(((y + down) * plane.Width) + x + across) - outside;
                double squared = span.Dot(span);
                double share = over.Dot(span) / squared;
                double rest = (over - (span * share)).Length;
                if (
                    // The colours can be distinguished, most of the pixel is the background, and it lies close to the line between both.
                    squared > MinContrast * MinContrast * variance
                    && share < MaxShare
                    && rest < (RimFraction * Math.Sqrt(squared)) + (RestDeviations * Math.Sqrt(variance))
                )
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>The colour beside the object: that of its shadow if the pixel lies next to it, otherwise that behind.</summary>
    private static Vector3D OutsideOf(ObjectPlane plane, int x, int y)
    {
        (Vector3D sum, int count) = (Vector3D.Zero, 0);
        foreach ((int across, int down) in Sides)
        {
            if (plane.StateAt(x + across, y + down) == PixelState.Shadow)
            {
                sum += plane.ColourAt(((y + down) * plane.Width) + x + across);
                count++;
            }
        }

        return count > 0 ? sum / count : plane.BehindAt((y * plane.Width) + x);
    }

    private bool Fill(ObjectPlane plane)
    {
        List<(int Index, Vector3D Colour)> filled = [];
        for (int y = 0; y < plane.Height; y++)
        {
            for (int x = 0; x < plane.Width; x++)
            {
                int index = (y * plane.Width) + x;
                int neighbours = NeighboursOf(plane, x, y);
                if (
                    plane.State[index] == PixelState.Other
                    && plane.Covers(x + plane.Left, y + plane.Top)
                    && neighbours >= FillNeighbours
                    && MeanAround(plane, x, y, 1, plane.Has) is { } around
                )
                {
                    int pixel = PixelOf(plane, x, y);
                    stack.Load(pixel);
                    Vector3D colour = stack.MeanIn(1);

                    // Noise of all three channels together has a standard deviation of √(3 v).
                    double limit = FillDeviations * Math.Sqrt(3 * noise.At(pixel));
                    if ((colour - around).Length < limit)
                    {
                        filled.Add((index, colour));
                    }
                }
            }
        }

        foreach ((int index, Vector3D colour) in filled)
        {
            plane.Set(index, colour, 1, colour, 1);
        }

        return filled.Count > 0;
    }

    private static Vector3D? MeanAround(ObjectPlane plane, int x, int y, int reach, Func<int, int, bool> counts)
    {
        (Vector3D sum, int count) = (Vector3D.Zero, 0);
        for (int v = y - reach; v <= y + reach; v++)
        {
            for (int u = x - reach; u <= x + reach; u++)
            {
                if (u >= 0 && v >= 0 && u < plane.Width && v < plane.Height && counts(u, v))
                {
                    sum += plane.ColourAt((v * plane.Width) + u);
                    count++;
                }
            }
        }

        return count > 0 ? sum / count : null;
    }

    private int PixelOf(ObjectPlane plane, int x, int y) => ((y + plane.Top) * imageWidth) + x + plane.Left;
}
