using Harvester.Sessions.Imaging;

namespace Harvester.Play.Screen;

/// <summary>
/// Distinguishes a failed copy of the screen from a dark image: a failed copy has the same colour in every pixel, while a night scene has
/// noise, lamps, or a gradient, however dark.
/// </summary>
internal static class PictureJudge
{
    // A failed copy is 0, and after a television-range conversion 16.
    private const int BrightestBlack = 16;

    /// <summary>Why an image shows nothing, one of <see cref="GrabRefusals"/>; null if it shows something.</summary>
    public static string? RefusalOf(PixelBuffer picture)
    {
        byte[] bytes = picture.Bytes;
        for (int i = PixelBuffer.BytesPerPixel; i < bytes.Length; i++)
        {
            if (bytes[i] != bytes[i - PixelBuffer.BytesPerPixel])
            {
                return null;
            }
        }

        return bytes[0] <= BrightestBlack && bytes[1] <= BrightestBlack && bytes[2] <= BrightestBlack
            ? GrabRefusals.Black
            : GrabRefusals.SingleColour;
    }
}
