using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>Finds the game's own display in pictures of a frozen world, in which nothing else changes but noise.</summary>
internal static class DisplayPixels
{
    /// <summary>A pixel of the display differs by more from the game behind it, grey levels.</summary>
    private const int ChangedLevels = 30;

    /// <summary>Fewer pixels are noise.</summary>
    private const int MinPixels = 24;

    /// <summary>
    /// The region of the pixels that differ from those of the other two pictures in the one with the display, while those two are equal;
    /// null if there are too few.
    /// </summary>
    /// <param name="before">The picture without the display, before it was shown.</param>
    /// <param name="shown">The picture with the display.</param>
    /// <param name="after">The picture without the display, after it was shown.</param>
    public static PictureRegion? Region(PixelBuffer before, PixelBuffer shown, PixelBuffer after)
    {
        int[] display =
        [
            .. PicturePixels
                .Changed(before, shown, ChangedLevels)
                .Where(pixel =>
                    PicturePixels.Difference(shown, after, pixel) > ChangedLevels
                    && PicturePixels.Difference(before, after, pixel) <= ChangedLevels
                ),
        ];
        return display.Length >= MinPixels ? PictureRegion.Of(display, before.Size) : null;
    }
}
