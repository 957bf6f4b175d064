using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Classifies the colours of lit lamps by hue, saturation and brightness.</summary>
internal static class LampColour
{
    /// <summary>Minimum brightness of a lit lamp; an unlit lamp in full sun is darker.</summary>
    private const int MinBrightness = 130;

    /// <summary>
    /// Minimum difference between the brightest and the darkest channel, as a fraction of the brightest; sky and walls have less.
    /// </summary>
    private const double MinSaturation = 0.35;

    /// <summary>The lamp whose colour a pixel has; unknown for any other colour.</summary>
    public static LightState Of(PixelBuffer picture, int column, int row)
    {
        int at = ((row * picture.Size.Width) + column) * PixelBuffer.BytesPerPixel;
        int red = picture.Bytes[at];
        int green = picture.Bytes[at + 1];
        int blue = picture.Bytes[at + 2];
        int brightest = Math.Max(red, Math.Max(green, blue));
        int darkest = Math.Min(red, Math.Min(green, blue));
        if (brightest < MinBrightness || brightest - darkest < MinSaturation * brightest)
        {
            return LightState.Unknown;
        }

        double sixth = 60.0 / (brightest - darkest);
        double hue =
            brightest == red ? (green - blue) * sixth
            : brightest == green ? 120 + ((blue - red) * sixth)
            : 240 + ((red - green) * sixth);
        return hue switch
        {
            >= -20 and < 22 => LightState.Red,
            >= 22 and < 60 => LightState.Amber,
            >= 90 and < 185 => LightState.Green,
            _ => LightState.Unknown,
        };
    }
}
