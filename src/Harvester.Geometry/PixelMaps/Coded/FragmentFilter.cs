using System;
using System.Collections.Generic;
using System.Linq;

namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>Judges connected pixels together: a faint fragment is noise or a moving texture, and a small closed hole is chance.</summary>
internal sealed class FragmentFilter(NoiseMap noise, int imageWidth)
{
    /// <summary>A fragment up to this size is dropped if its contrast is no more than so many standard deviations of the noise.</summary>
    private const int FaintPixels = 16;
    private const double FaintDeviations = 4;

    /// <summary>A closed hole up to this size, or this fraction of the object's pixels, is filled.</summary>
    private const int MinHolePixels = 4;
    private const double HoleFraction = 0.015;

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
            if (hole.Count <= most && !hole.Exists(index => plane.IsSettled[index] || IsAtBorder(plane, index)))
            {
                hole.ForEach(index => plane.State[index] = PixelState.Object);
            }
        }
    }

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
            variance += noise.At((((index / plane.Width) + plane.Top) * imageWidth) + (index % plane.Width) + plane.Left);
        }

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
