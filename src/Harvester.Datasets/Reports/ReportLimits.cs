namespace Harvester.Datasets.Reports;

/// <summary>
/// How much of a session goes into a report, so that a browser opens it at once. The figures are of the whole session all the same.
/// </summary>
/// <param name="Frames">Frames at most; at least 1.</param>
/// <param name="ImageBytes">Size of their images' files together at most, bytes; one frame is always shown.</param>
public sealed record ReportLimits(int Frames = 100, long ImageBytes = 48L * 1024 * 1024)
{
    /// <summary>Whether images are links to the session's files instead: a small page, which shows them only where it finds them.</summary>
    public bool LinksImages { get; init; }
}
