namespace Harvester.Sessions.Imaging;

/// <summary>File formats of images.</summary>
public enum ImageFormat
{
    /// <summary>Portable Network Graphics: lossless, compressed.</summary>
    Png,

    /// <summary>Windows bitmap: lossless, uncompressed; the fastest to write and the largest.</summary>
    Bmp,

    /// <summary>JPEG, baseline: lossy, the smallest, and fast to write.</summary>
    Jpeg,
}
