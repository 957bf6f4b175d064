namespace Harvester.Sessions.Imaging;

/// <summary>Properties of image formats.</summary>
public static class ImageFormats
{
    /// <summary>The file extension, including the dot.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such format.</exception>
    public static string Extension(this ImageFormat format) =>
        format switch
        {
            ImageFormat.Png => ".png",
            ImageFormat.Bmp => ".bmp",
            ImageFormat.Jpeg => ".jpg",
            _ => throw new ArgumentOutOfRangeException(nameof(format), format, null),
        };
}
