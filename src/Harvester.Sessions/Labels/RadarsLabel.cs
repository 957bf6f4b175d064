namespace Harvester.Sessions.Labels;

/// <summary>What the radars of a rig detected at a moment.</summary>
/// <param name="Scans">One scan of each radar, in the order of the rig.</param>
public sealed record RadarsLabel(IReadOnlyList<RadarScan> Scans) : IChannelLabel
{
    /// <inheritdoc />
    public IEnumerable<string> Files => [];
}
