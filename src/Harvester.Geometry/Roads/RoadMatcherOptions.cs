
namespace Harvester.Geometry.Roads;

/// <summary>
/// What the matcher takes for likely. A misfit as large as one of the deviations costs 1; costs are squares of misfits, added.
/// </summary>
public sealed record RoadMatcherOptions
{
    /// <summary>Deviation of a car from the carriageway of its direction, metres outside of it.</summary>
    public double LateralDeviation { get; init; } = 0.6;

    /// <summary>Deviation of a car's heading from the road's, degrees.</summary>
    public double HeadingDeviationDegrees { get; init; } = 10;

    /// <summary>Deviation of a car's height from the line between the nodes, metres.</summary>
    public double HeightDeviation { get; init; } = 1.5;

    /// <summary>A car whose heading differs by more from the road's does not follow it, degrees.</summary>
    public double LargestHeadingErrorDegrees { get; init; } = 60;

    /// <summary>A road whose height differs by more is another one, metres.</summary>
    public double MaxHeightDifference { get; init; } = 4;

    /// <summary>How far beside the carriageway a car still follows its road, metres.</summary>
    public double LargestDistanceBeside { get; init; } = 6;

    /// <summary>
    /// A car that is less far beside its carriageway counts to the outermost lane, metres where lanes are 4 m wide, and in proportion
    /// elsewhere: as far as the indicators on marking are valid.
    /// </summary>
    public double EdgeTolerance { get; init; } = LaneSection.ReachOutsideTheRoad;

    /// <summary>What leaving the road that was followed costs.</summary>
    public double CostOfLeaving { get; init; } = 6;

    /// <summary>What a slip lane costs that was not followed before.</summary>
    public double CostOfSlipLane { get; init; } = 1;

    /// <summary>Cost of a road that the data does not have: a road that costs more is no explanation.</summary>
    public double CostOfUnknownRoad { get; init; } = 20;

    /// <summary>The least confidence of a match that is not called ambiguous.</summary>
    public double LeastConfidence { get; init; } = 0.6;
}
