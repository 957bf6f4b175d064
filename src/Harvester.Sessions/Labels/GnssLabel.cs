namespace Harvester.Sessions.Labels;

/// <summary>What the satellite receiver reported since the frame, or moment, before.</summary>
/// <param name="Samples">The samples, in ascending order of time; the last at the frame's own time at the latest.</param>
public sealed record GnssLabel(IReadOnlyList<GnssSample> Samples) : IChannelLabel
{
    /// <inheritdoc />
    public IEnumerable<string> Files => [];
}
