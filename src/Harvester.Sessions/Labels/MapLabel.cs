using Harvester.Sessions.Semantics;

namespace Harvester.Sessions.Labels;

/// <summary>The map of a channel that has one map for each frame.</summary>
/// <param name="Key">The key of the channel.</param>
/// <param name="File">Its path within the session, with forward slashes.</param>
/// <param name="Method">Where its values come from.</param>
/// <param name="RaysCast">The rays cast for it alone.</param>
public sealed record MapLabel(string Key, string File, SemanticsMethod Method, int RaysCast) : IChannelLabel
{
    /// <inheritdoc />
    public IEnumerable<string> Files => [File];
}
