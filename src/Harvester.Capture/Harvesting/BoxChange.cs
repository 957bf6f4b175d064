using Harvester.Geometry;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>Whether pictures differ in boxes by more than two pictures of the same moment, whose difference is noise.</summary>
/// <param name="first">A picture of the moment.</param>
/// <param name="second">Another one.</param>
internal sealed class BoxChange(PixelBuffer first, PixelBuffer second)
{
    /// <summary>The greatest of a few noise levels is exceeded by others, but hardly by half.</summary>
    private const double NoiseFactor = 1.5;

    /// <summary>So many pixels that change are no chance.</summary>
    private const int MinPixels = 4;

    /// <summary>Whether a picture differs in some boxes from the first one.</summary>
    public bool IsSeen(PixelBuffer picture, IReadOnlyList<Box2D> boxes)
    {
        int noise = 0;
        foreach (int pixel in PixelsIn(boxes))
        {
            noise = Math.Max(noise, Difference(first, second, pixel));
        }

        int changed = 0;
        foreach (int pixel in PixelsIn(boxes))
        {
            changed += Difference(first, picture, pixel) > NoiseFactor * noise ? 1 : 0;
        }

        return changed >= MinPixels;
    }

    private IEnumerable<int> PixelsIn(IReadOnlyList<Box2D> boxes)
    {
        int width = first.Size.Width;
        foreach (Box2D box in boxes)
        {
            int bottom = Math.Min(first.Size.Height, (int)Math.Ceiling(box.YMax));
            int right = Math.Min(width, (int)Math.Ceiling(box.XMax));
            for (int row = Math.Max(0, (int)box.YMin); row < bottom; row++)
            {
                for (int column = Math.Max(0, (int)box.XMin); column < right; column++)
                {
                    yield return (row * width) + column;
                }
            }
        }
    }

    private static int Difference(PixelBuffer a, PixelBuffer b, int pixel)
    {
        int at = 3 * pixel;
        return Math.Max(
            Math.Abs(a.Bytes[at] - b.Bytes[at]),
            Math.Max(Math.Abs(a.Bytes[at + 1] - b.Bytes[at + 1]), Math.Abs(a.Bytes[at + 2] - b.Bytes[at + 2]))
        );
    }
}
