namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>Judges connected pixels together: a faint fragment is noise or a moving texture, and a small closed hole is chance.</summary>
internal sealed class FragmentFilter(NoiseMap noise, int imageWidth)
{
    /// <summary>A fragment up to this size is dropped if its contrast is no more than this many standard deviations of the noise.</summary>
    private const int FaintPixels = 16;
    private const double FaintDeviations = 4;

    /// <summary>A closed hole up to this size, or this fraction of the object's pixels, is filled.</summary>
    private const int MinHolePixels = 4;
    private const double HoleFraction = 0.015;

    /// <summary>
    /// A larger one is filled up to this fraction if its colour differs by no more than this from the object's, grey levels.
    /// </summary>
    private const double LikeFraction = 0.2;
    private const double LikeLevels = 12;

    private static readonly (int Across, int Down)[] Sides = [(-1, 0), (1, 0), (0, -1), (0, 1)];
    private static readonly (int Across, int Down)[] Around = [.. Sides, (-1, -1), (1, -1), (-1, 1), (1, 1)];

    /// <summary>Drops fragments that hardly differ from what is behind them.</summary>
    public void DropFaint(ObjectPlane plane)
    {
        foreach (List<int> fragment in Regions(plane, Around, static state => state == PixelState.Object))
        {
            if (fragment.Count <= FaintPixels && (fragment.Count == 1 || IsFaint(plane, fragment)))
            {
                fragment.ForEach(index => plane.State[index] = PixelState.Other);
            }
        }
    }

    /// <summary>Fills small holes, in which object and background look alike by chance.</summary>
    public static void FillHoles(ObjectPlane plane)
    {
        int most = (int)Math.Max(MinHolePixels, HoleFraction * plane.State.Count(static state => state == PixelState.Object));
        foreach (List<int> hole in Regions(plane, Sides, static state => state != PixelState.Object))
        {
            if (hole.Count <= most && !hole.Exists(index => IsAtBorder(plane, index)))
            {
                hole.ForEach(index => plane.State[index] = PixelState.Object);
            }
        }
    }

    /// <summary>
    /// Fills larger places that the object and its shadow enclose, if they have the object's colour at the border: the ground that is seen
    /// when the object is hidden has that colour too.
    /// </summary>
    /// <param name="plane">The plane.</param>
    /// <param name="picture">The picture with all objects.</param>
    public void FillLikes(ObjectPlane plane, byte[] picture)
    {
        int most = (int)(LikeFraction * plane.State.Count(static state => state == PixelState.Object));
        foreach (List<int> region in Regions(plane, Sides, static state => state == PixelState.Other))
        {
            if (region.Count <= most && !region.Exists(index => IsAtBorder(plane, index)) && IsLikeAround(plane, region, picture))
            {
                region.ForEach(index => plane.State[index] = PixelState.Object);
            }
        }
    }

    private bool IsLikeAround(ObjectPlane plane, List<int> region, byte[] picture)
    {
        // Each pair of a pixel of the region and a neighbour of the object adds the distance of their colours.
        (double difference, int count) = (0, 0);
        foreach (int index in region)
        {
            foreach ((int across, int down) in Sides)
            {
                int beside = index + across + (down * plane.Width);
                if (plane.State[beside] == PixelState.Object)
                {
                    int pixel = 3 * PixelOf(plane, index);
                    var colour = new Vector3D(picture[pixel], picture[pixel + 1], picture[pixel + 2]);
                    difference += (colour - plane.ColourAt(beside)).Length;
                    count++;
                }
            }
        }

        // The region counts as enclosed by the object if its pairs are more than half of the pixels at its border.
        return 2 * count > region.Count(index => IsBeside(plane, index)) && difference < LikeLevels * count;
    }

    private static bool IsBeside(ObjectPlane plane, int index) =>
        Array.Exists(Sides, side => plane.State[index + side.Across + (side.Down * plane.Width)] != PixelState.Other);

    private int PixelOf(ObjectPlane plane, int index) =>
        (((index / plane.Width) + plane.Top) * imageWidth) + (index % plane.Width) + plane.Left;

    private static bool IsAtBorder(ObjectPlane plane, int index)
    {
        (int x, int y) = (index % plane.Width, index / plane.Width);
        return x == 0 || y == 0 || x == plane.Width - 1 || y == plane.Height - 1;
    }

    private bool IsFaint(ObjectPlane plane, List<int> fragment)
    {
        (double contrast, double variance) = (0, 0);
        foreach (int index in fragment)
        {
            contrast += (plane.ColourAt(index) - plane.BehindAt(index)).Length;
            variance += noise.At(PixelOf(plane, index));
        }

        // The mean distance of the colours, against the standard deviation of one channel of one pixel.
        return contrast / fragment.Count < FaintDeviations * Math.Sqrt(variance / fragment.Count);
    }

    private static IEnumerable<List<int>> Regions(ObjectPlane plane, (int Across, int Down)[] neighbours, Func<PixelState, bool> belongs)
    {
        var visited = new bool[plane.State.Length];
        for (int start = 0; start < plane.State.Length; start++)
        {
            if (visited[start] || !belongs(plane.State[start]))
            {
                continue;
            }

            visited[start] = true;
            List<int> region = [start];

            // Flood fill in breadth: the list of the region is the queue.
            for (int next = 0; next < region.Count; next++)
            {
                foreach ((int across, int down) in neighbours)
                {
                    (int u, int v) = ((region[next] % plane.Width) + across, (region[next] / plane.Width) + down);
                    int at = (v * plane.Width) + u;
                    if (u >= 0 && v >= 0 && u < plane.Width && v < plane.Height && !visited[at] && belongs(plane.State[at]))
                    {
                        visited[at] = true;
                        region.Add(at);
                    }
                }
            }

            yield return region;
        }
    }
}
