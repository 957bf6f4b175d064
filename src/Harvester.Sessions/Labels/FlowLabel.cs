using Harvester.Sessions.Semantics;

namespace Harvester.Sessions.Labels;

/// <summary>The dense motion between a frame and the one before. File formats: docs/flow.md.</summary>
/// <param name="From">Number of the frame before, of the same view.</param>
/// <param name="Method">Where the depths come from.</param>
/// <param name="Maps">The paths of the maps.</param>
public sealed record FlowLabel(int From, SemanticsMethod Method, FlowFiles Maps) : IChannelLabel
{
    /// <summary>
    /// Error of the flow that 95 % of the pixels with a flow, in both directions, are estimated not to exceed, pixels; null for exact
    /// depths.
    /// </summary>
    public double? ErrorPixels { get; init; }

    /// <summary>The rays cast for it alone.</summary>
    public int RaysCast { get; init; }

    /// <inheritdoc />
    public IEnumerable<string> Files => Maps.All;
}
