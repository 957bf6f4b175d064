using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Imaging;

/// <summary>
/// An image in memory that is reused from frame to frame: 3 bytes per pixel, red, green, blue, rows from the top, no padding.
/// </summary>
public sealed class PixelBuffer
{
    /// <summary>Bytes of one pixel.</summary>
    public const int BytesPerPixel = 3;

    /// <summary>Creates a black image.</summary>
    public PixelBuffer(ImageSize size)
    {
        Size = size;
        Bytes = new byte[checked(size.PixelCount * BytesPerPixel)];
    }

    /// <summary>Width and height in pixels.</summary>
    public ImageSize Size { get; }

    /// <summary>The pixels' bytes: the buffer's own storage.</summary>
    public byte[] Bytes { get; }
}
