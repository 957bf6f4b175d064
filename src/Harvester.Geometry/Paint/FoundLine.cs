using Harvester.Geometry.Lanes;

namespace Harvester.Geometry.Paint;

/// <summary>A painted line on a chain.</summary>
/// <param name="From">Where its paint begins, metres from the chain's start.</param>
/// <param name="To">Where its paint ends.</param>
/// <param name="Stripes">Its stripes, in the order of the chain; at least one.</param>
/// <param name="Paint">Style, colour and width.</param>
/// <param name="Contrast">Median contrast of its stripes.</param>
internal sealed record FoundLine(double From, double To, IReadOnlyList<StripeCluster> Stripes, MarkingPaint Paint, double Contrast)
{
    /// <summary>The dashes, with the phase as a station of the chain; null for other lines, and if their pattern is unknown.</summary>
    public DashPattern? Dashes { get; init; }

    public double Length => To - From;
}
