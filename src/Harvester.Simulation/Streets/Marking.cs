using Harvester.Geometry.Lanes;

namespace Harvester.Simulation.Streets;

/// <summary>A line painted along a road.</summary>
/// <param name="Offset">Its centre line, metres to the right of the road's line.</param>
/// <param name="Kind">How it is painted.</param>
/// <param name="Sizes">The sizes of the paint of its road.</param>
internal readonly record struct Marking(double Offset, MarkingKind Kind, RoadPaint Sizes)
{
    public bool IsDashed => Kind is MarkingKind.LaneDashed or MarkingKind.CentreDashed;

    public bool IsYellow => Kind is MarkingKind.Centre or MarkingKind.CentreDouble or MarkingKind.CentreDashed;

    public MarkingPaint Paint =>
        new(
            IsDashed ? MarkingStyle.Dashed
                : Kind == MarkingKind.CentreDouble ? MarkingStyle.DoubleSolid
                : MarkingStyle.Solid,
            IsYellow ? MarkingColour.Yellow : MarkingColour.White,
            Kind == MarkingKind.CentreDouble ? Sizes.BetweenStripes + Sizes.StripeWidth : Sizes.StripeWidth
        );

    /// <summary>The offsets of the edges of its stripes.</summary>
    public IEnumerable<(double Left, double Right)> Stripes()
    {
        double half = Sizes.StripeWidth / 2;
        double apart = Sizes.BetweenStripes / 2;
        foreach (double middle in Kind == MarkingKind.CentreDouble ? new[] { Offset - apart, Offset + apart } : [Offset])
        {
            yield return (middle - half, middle + half);
        }
    }
}
