using System.Globalization;
using Harvester.Capture.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>Where a frame's files lie within a session, with forward slashes.</summary>
public static class FramePaths
{
    /// <summary>Folder of the screenshots.</summary>
    public const string Frames = "frames";

    /// <summary>Folder of the instance masks.</summary>
    public const string Masks = "masks";

    /// <summary>Path of a screenshot.</summary>
    public static string Image(int frame, ImageFormat format) => $"{Frames}/{Number(frame)}.{(format == ImageFormat.Png ? "png" : "bmp")}";

    /// <summary>Path of an instance mask.</summary>
    public static string Mask(int frame) => $"{Masks}/{Number(frame)}.png";

    private static string Number(int frame) => frame.ToString("D8", CultureInfo.InvariantCulture);
}
