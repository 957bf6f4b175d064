namespace Harvester.Capture.Imaging;

/// <summary>How screenshots are stored.</summary>
public enum ImageFormat
{
    /// <summary>Portable Network Graphics: without loss, compressed.</summary>
    Png,

    /// <summary>Windows bitmap: without loss, not compressed; the fastest to write and the largest.</summary>
    Bmp,
}
