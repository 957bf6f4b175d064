namespace Harvester.Sessions.Labels;

/// <summary>The depth maps of a frame. File format: docs/depth.md.</summary>
/// <param name="Sparse">Path within the session of the depths that rays measured, with forward slashes.</param>
/// <param name="Completed">Path of the depths of all pixels; null without a mask.</param>
/// <param name="Error">Path of their estimated errors; null without a mask.</param>
/// <param name="RaysCast">The rays cast for them alone.</param>
/// <param name="MeasuredPixels">Number of pixels with a measured depth.</param>
public sealed record DepthLabel(string Sparse, string? Completed, string? Error, int RaysCast, int MeasuredPixels) : IChannelLabel
{
    /// <inheritdoc />
    public IEnumerable<string> Files
    {
        get
        {
            yield return Sparse;
            if (Completed is not null && Error is not null)
            {
                yield return Completed;
                yield return Error;
            }
        }
    }
}
