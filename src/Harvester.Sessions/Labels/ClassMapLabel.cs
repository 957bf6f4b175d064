using Harvester.Sessions.Semantics;

namespace Harvester.Sessions.Labels;

/// <summary>The class map of a frame.</summary>
/// <param name="File">Its path within the session, with forward slashes.</param>
/// <param name="Method">Where its classes come from.</param>
/// <param name="RaysCast">The rays cast for it.</param>
/// <param name="InterpolatedPixels">Number of its pixels that show no object of the mask and were drawn without a ray.</param>
public sealed record ClassMapLabel(string File, SemanticsMethod Method, int RaysCast, int InterpolatedPixels) : IChannelLabel
{
    /// <inheritdoc />
    public IEnumerable<string> Files => [File];
}
