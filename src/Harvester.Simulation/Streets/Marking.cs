using Harvester.Geometry.Lanes;

namespace Harvester.Simulation.Streets;

/// <summary>A line painted along a road.</summary>
/// <param name="Offset">Its centre line, metres to the right of the road's line.</param>
/// <param name="Kind">How it is painted.</param>
internal readonly record struct Marking(double Offset, MarkingKind Kind)
{
    private const double StripeWidth = 0.15;
    private const double BetweenStripes = 0.3;

    public bool IsDashed => Kind is MarkingKind.LaneDashed or MarkingKind.CentreDashed;

    public bool IsYellow => Kind is MarkingKind.Centre or MarkingKind.CentreDouble or MarkingKind.CentreDashed;

    public MarkingPaint Paint =>
        new(
            IsDashed ? MarkingStyle.Dashed
                : Kind == MarkingKind.CentreDouble ? MarkingStyle.DoubleSolid
                : MarkingStyle.Solid,
            IsYellow ? MarkingColour.Yellow : MarkingColour.White,
            Kind == MarkingKind.CentreDouble ? BetweenStripes + StripeWidth : StripeWidth
        );

    /// <summary>The offsets of the edges of its stripes.</summary>
    public IEnumerable<(double Left, double Right)> Stripes()
    {
        const double half = StripeWidth / 2;
        foreach (
            double middle in Kind == MarkingKind.CentreDouble
                ? new[] { Offset - (BetweenStripes / 2), Offset + (BetweenStripes / 2) }
                : [Offset]
        )
        {
            yield return (middle - half, middle + half);
        }
    }
}
