using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Sessions.Labels;

/// <summary>
/// The pixels of an object including those that other objects hide, within a box of whole pixels. Row by row from the upper left, runs of
/// pixels outside and inside the object take turns, beginning with outside.
/// </summary>
/// <param name="Left">First column of the box.</param>
/// <param name="Top">First row of the box.</param>
/// <param name="Width">Width of the box, pixels; at least 1.</param>
/// <param name="Height">Height of the box, pixels; at least 1.</param>
/// <param name="Runs">Lengths of the runs, pixels; their sum is the area of the box.</param>
public sealed record AmodalMask(int Left, int Top, int Width, int Height, IReadOnlyList<int> Runs)
{
    /// <summary>The box around the mask, pixels from the image's upper left corner.</summary>
    public Box2D Box => new(Left, Top, Left + Width, Top + Height);

    /// <summary>The runs of a map with at least one pixel.</summary>
    public static AmodalMask Of(PixelMap pixels)
    {
        if (pixels is null || pixels.Count == 0)
        {
            throw new ArgumentException("An amodal mask has at least one pixel.", nameof(pixels));
        }

        (int left, int top, int right, int bottom) = BoundsOf(pixels);
        List<int> runs = [0];
        bool isInside = false;
        for (int row = top; row <= bottom; row++)
        {
            for (int column = left; column <= right; column++)
            {
                if (pixels[column, row] != isInside)
                {
                    isInside = !isInside;
                    runs.Add(0);
                }

                runs[runs.Count - 1]++;
            }
        }

        return new AmodalMask(left, top, right - left + 1, bottom - top + 1, runs);
    }

    /// <summary>The mask as a map.</summary>
    /// <param name="image">Size of the image.</param>
    /// <exception cref="ArgumentException">The runs do not fill the box, or the box lies outside the image.</exception>
    public PixelMap ToMap(ImageSize image)
    {
        if (ProblemIn(image) is { } problem)
        {
            throw new ArgumentException(problem, nameof(image));
        }

        var map = new PixelMap(image);
        int at = 0;
        for (int run = 0; run < Runs.Count; run++)
        {
            for (int end = at + Runs[run]; at < end; at++)
            {
                if (run % 2 == 1)
                {
                    map[Left + (at % Width), Top + (at / Width)] = true;
                }
            }
        }

        return map;
    }

    /// <summary>What is wrong with the mask in an image; null if nothing is.</summary>
    public string? ProblemIn(ImageSize image)
    {
        if (Left < 0 || Top < 0 || Width < 1 || Height < 1 || Left > image.Width - Width || Top > image.Height - Height)
        {
            return "The box of amodalMask does not lie in the image.";
        }

        long sum = 0;
        foreach (int run in Runs)
        {
            sum += Math.Max(0, run);
        }

        return sum == (long)Width * Height ? null : "The runs of amodalMask do not fill its box.";
    }

    private static (int Left, int Top, int Right, int Bottom) BoundsOf(PixelMap pixels)
    {
        (int left, int top, int right, int bottom) = (int.MaxValue, int.MaxValue, -1, -1);
        for (int row = 0; row < pixels.Image.Height; row++)
        {
            for (int column = 0; column < pixels.Image.Width; column++)
            {
                if (pixels[column, row])
                {
                    (left, top) = (Math.Min(left, column), Math.Min(top, row));
                    (right, bottom) = (Math.Max(right, column), row);
                }
            }
        }

        return (left, top, right, bottom);
    }
}
