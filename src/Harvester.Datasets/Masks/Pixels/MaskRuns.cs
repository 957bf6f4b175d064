using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Masks.Pixels;

/// <summary>
/// Run lengths of a mask in COCO's layout: down the first column, then the next; the first count is of pixels outside, and may be 0.
/// </summary>
internal static class MaskRuns
{
    /// <summary>Counts the runs of one object's pixels.</summary>
    /// <param name="map">The map.</param>
    /// <param name="number">The object's number; 1 or more.</param>
    /// <returns>Lengths of runs outside and inside in turn; their sum is the number of pixels of the image.</returns>
    public static IReadOnlyList<int> Encode(InstanceMap map, ushort number)
    {
        var counts = new List<int>();
        bool inside = false;
        int run = 0;
        for (int column = 0; column < map.Image.Width; column++)
        {
            for (int row = 0; row < map.Image.Height; row++)
            {
                if ((map[column, row] == number) != inside)
                {
                    counts.Add(run);
                    run = 0;
                    inside = !inside;
                }

                run++;
            }
        }

        counts.Add(run);
        return counts;
    }

    /// <summary>The pixel map of run lengths.</summary>
    /// <param name="counts">As <see cref="Encode"/> gives them.</param>
    /// <param name="image">The image's size.</param>
    /// <exception cref="ArgumentException">A count is negative, or they do not add up to the image's pixels.</exception>
    public static PixelMap Decode(IReadOnlyList<int> counts, ImageSize image)
    {
        var map = new PixelMap(image);
        long at = 0;
        for (int i = 0; i < counts.Count; i++)
        {
            if (counts[i] < 0 || at + counts[i] > image.PixelCount)
            {
                throw new ArgumentException("Run lengths must not be negative and must add up to the image's pixels.", nameof(counts));
            }

            for (int end = (int)at + counts[i]; at < end; at++)
            {
                if (i % 2 == 1)
                {
                    map[(int)at / image.Height, (int)at % image.Height] = true;
                }
            }
        }

        return at == image.PixelCount
            ? map
            : throw new ArgumentException("Run lengths must not be negative and must add up to the image's pixels.", nameof(counts));
    }
}
