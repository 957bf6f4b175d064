using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Masks.Pixels;

/// <summary>Run lengths of a mask in COCO's layout: by columns, beginning with the pixels outside, whose count may be 0.</summary>
internal static class MaskRuns
{
    /// <summary>Encodes the pixels of one object, without reading a pixel outside the box around them.</summary>
    /// <returns>Lengths of alternating runs outside and inside; they add up to the number of pixels of the image.</returns>
    public static IReadOnlyList<int> Encode(InstancePixels pixels)
    {
        ushort[] ids = pixels.Map.Ids;
        int width = pixels.Map.Image.Width;
        int height = pixels.Map.Image.Height;
        var counts = new List<int>();
        bool inside = false;
        int start = 0;
        for (int column = pixels.Left; column < pixels.Right; column++)
        {
            for (int row = pixels.Top, at = (row * width) + column; row < pixels.Bottom; row++, at += width)
            {
                if ((ids[at] == pixels.Id) != inside)
                {
                    Turn((column * height) + row);
                }
            }

            if (inside && pixels.Bottom < height)
            {
                Turn((column * height) + pixels.Bottom);
            }

            if (inside && column + 1 < width && (pixels.Top > 0 || column + 1 == pixels.Right))
            {
                Turn((column + 1) * height);
            }
        }

        counts.Add((width * height) - start);
        return counts;

        void Turn(int place)
        {
            counts.Add(place - start);
            start = place;
            inside = !inside;
        }
    }

    /// <summary>Decodes run lengths to a map.</summary>
    /// <param name="counts">The run lengths, as <see cref="Encode"/> returns them.</param>
    /// <param name="image">Size of the image.</param>
    /// <exception cref="ArgumentException">A count is negative, or they do not add up to the number of pixels.</exception>
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
