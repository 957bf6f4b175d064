namespace Harvester.Sessions.Labels;

/// <summary>What the LiDARs of a rig saw at a moment.</summary>
/// <param name="Sweeps">One sweep of each LiDAR, in the order of the rig.</param>
public sealed record SweepsLabel(IReadOnlyList<SweepLabel> Sweeps) : IChannelLabel
{
    /// <inheritdoc />
    public IEnumerable<string> Files => Sweeps.Select(sweep => sweep.File);
}
