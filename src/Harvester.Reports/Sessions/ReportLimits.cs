namespace Harvester.Reports.Sessions;

/// <summary>Limits of a report, so that a browser opens it quickly. The statistics always cover the whole session.</summary>
/// <param name="Frames">Largest number of frames; at least 1.</param>
/// <param name="Labels">Largest number of labels in them together.</param>
/// <param name="ImageBytes">
/// Largest total size of the embedded JPEG images, bytes; they are scaled down to it. At least one frame is always shown.
/// </param>
public sealed record ReportLimits(int Frames = 100, int Labels = 100_000, long ImageBytes = 5_500_000)
{
    /// <summary>Whether images are linked instead of embedded: the page is small, and works only next to the session.</summary>
    public bool LinksImages { get; init; }

    /// <summary>Whether the page draws the posts of signs and lights at first; it has a switch for them.</summary>
    public bool ShowsPosts { get; init; }

    /// <summary>Largest total size of embedded instance masks, bytes; the page has none if they need more.</summary>
    public long MaskBytes { get; init; } = 1_500_000;
}
