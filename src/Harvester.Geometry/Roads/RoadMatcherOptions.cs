namespace Harvester.Geometry.Roads;

/// <summary>
/// The deviations and costs of the matcher. A misfit as large as its deviation costs 1; costs are squared misfits, added up.
/// </summary>
public sealed record RoadMatcherOptions
{
    /// <summary>Deviation of a car outside the carriageway of its direction, metres.</summary>
    public double LateralDeviation { get; init; } = 0.6;

    /// <summary>Deviation of a car's heading from the road's, degrees.</summary>
    public double HeadingDeviationDegrees { get; init; } = 10;

    /// <summary>Deviation of a car's height from the line between the nodes, metres.</summary>
    public double HeightDeviation { get; init; } = 1.5;

    /// <summary>Maximum difference between the headings of a car and a road that it follows, degrees.</summary>
    public double MaxHeadingErrorDegrees { get; init; } = 60;

    /// <summary>Maximum height difference between a car and its road, metres; a larger one means another road.</summary>
    public double MaxHeightDifference { get; init; } = 4;

    /// <summary>Maximum distance beside the carriageway at which a car still follows its road, metres.</summary>
    public double MaxDistanceBeside { get; init; } = 6;

    /// <summary>
    /// Maximum distance beside the carriageway at which a car counts to the outermost lane, metres for lanes 4 m wide, and in proportion
    /// for others: as far as the indicators on marking are valid.
    /// </summary>
    public double EdgeTolerance { get; init; } = LaneSection.ReachOutsideTheRoad;

    /// <summary>Cost of leaving the road followed before.</summary>
    public double CostOfLeaving { get; init; } = 6;

    /// <summary>Cost of a slip lane that was not followed before.</summary>
    public double CostOfSlipLane { get; init; } = 1;

    /// <summary>Cost of a road missing from the data: a candidate that costs more is rejected.</summary>
    public double CostOfUnknownRoad { get; init; } = 20;

    /// <summary>Minimum confidence of a match; below it, the match is ambiguous.</summary>
    public double MinConfidence { get; init; } = 0.6;
}
