namespace Harvester.Sessions.Labels;

/// <summary>The further pictures of a frame's moment.</summary>
/// <param name="Pairs">The pictures, and those that are missing.</param>
public sealed record PairsLabel(IReadOnlyList<PairLabel> Pairs) : IChannelLabel
{
    /// <inheritdoc />
    public IEnumerable<string> Files => Pairs.Select(pair => pair.File).OfType<string>();
}
