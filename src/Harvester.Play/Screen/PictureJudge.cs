using Harvester.Sessions.Imaging;

namespace Harvester.Play.Screen;

/// <summary>
/// Tells a picture that shows nothing from a dark one: a failed copy of the screen has one colour in every pixel, while a night
/// scene has noise, lamps, or a gradient, however dark.
/// </summary>
internal static class PictureJudge
{
    // A failed copy is 0, and after a television-range conversion 16.
    private const int BrightestBlack = 16;

    /// <summary>Why a picture shows nothing, one of <see cref="GrabRefusals"/>; null when it shows something.</summary>
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
