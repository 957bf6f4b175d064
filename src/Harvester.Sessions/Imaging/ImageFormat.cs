namespace Harvester.Sessions.Imaging;

/// <summary>How screenshots are stored.</summary>
public enum ImageFormat
{
    /// <summary>Portable Network Graphics: without loss, compressed.</summary>
    Png,

    /// <summary>Windows bitmap: without loss, not compressed; the fastest to write and the largest.</summary>
    Bmp,

    /// <summary>JPEG, baseline: with loss, the smallest and fast to write.</summary>
    Jpeg,
}
