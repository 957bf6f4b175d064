using System;

namespace Harvester.Geometry.Lanes;

/// <summary>
/// The thirteen indicators of DeepDriving (Chen et al. 2015; Figure 15 of the thesis). Distances to markings are metres across the
/// road, negative to the left of the car and positive to the right. Distances to vehicles are metres along the road. Two systems
/// describe the car's place: in lane (LL, ML, MR, RR) while it is well within a lane, on marking (L, M, R) while it is near a
/// marking; in between both are active.
/// </summary>
public sealed record LaneIndicators
{
    /// <summary>Heading of the road less that of the car, radians in (-pi, pi]; positive when the car points to the right of the road, as in TORCS.</summary>
    public required Indicator Angle { get; init; }

    /// <summary>On marking: to the marking left of the one the car is on.</summary>
    public required Indicator ToMarkingL { get; init; }

    /// <summary>On marking: to the marking the car is on.</summary>
    public required Indicator ToMarkingM { get; init; }

    /// <summary>On marking: to the marking right of the one the car is on.</summary>
    public required Indicator ToMarkingR { get; init; }

    /// <summary>On marking: to the nearest vehicle ahead in the lane left of the marking.</summary>
    public required Indicator DistL { get; init; }

    /// <summary>On marking: to the nearest vehicle ahead in the lane right of the marking.</summary>
    public required Indicator DistR { get; init; }

    /// <summary>In lane: to the left marking of the lane to the left.</summary>
    public required Indicator ToMarkingLL { get; init; }

    /// <summary>In lane: to the left marking of the car's lane.</summary>
    public required Indicator ToMarkingML { get; init; }

    /// <summary>In lane: to the right marking of the car's lane.</summary>
    public required Indicator ToMarkingMR { get; init; }

    /// <summary>In lane: to the right marking of the lane to the right.</summary>
    public required Indicator ToMarkingRR { get; init; }

    /// <summary>In lane: to the nearest vehicle ahead in the lane to the left.</summary>
    public required Indicator DistLL { get; init; }

    /// <summary>In lane: to the nearest vehicle ahead in the car's lane.</summary>
    public required Indicator DistMM { get; init; }

    /// <summary>In lane: to the nearest vehicle ahead in the lane to the right.</summary>
    public required Indicator DistRR { get; init; }

    /// <summary>Nothing known: every indicator at its inactive value.</summary>
    public static LaneIndicators Unknown { get; } = new()
    {
        Angle = Indicator.Inactive(0),
        ToMarkingL = IndicatorRanges.ToMarkingL.Inactive,
        ToMarkingM = IndicatorRanges.ToMarkingM.Inactive,
        ToMarkingR = IndicatorRanges.ToMarkingR.Inactive,
        DistL = IndicatorRanges.Dist.Inactive,
        DistR = IndicatorRanges.Dist.Inactive,
        ToMarkingLL = IndicatorRanges.ToMarkingLL.Inactive,
        ToMarkingML = IndicatorRanges.ToMarkingML.Inactive,
        ToMarkingMR = IndicatorRanges.ToMarkingMR.Inactive,
        ToMarkingRR = IndicatorRanges.ToMarkingRR.Inactive,
        DistLL = IndicatorRanges.Dist.Inactive,
        DistMM = IndicatorRanges.Dist.Inactive,
        DistRR = IndicatorRanges.Dist.Inactive,
    };

    /// <summary>The same with every distance to a marking and every one to a vehicle put through a function, the markings first, in the order of the members here.</summary>
    /// <param name="toMarking">Makes another of a distance to a marking, metres.</param>
    /// <param name="dist">Makes another of a distance to a vehicle, metres.</param>
    /// <returns>The angle stays as it is.</returns>
    public LaneIndicators Select(Func<Indicator, Indicator> toMarking, Func<Indicator, Indicator> dist)
    {
        Guard.NotNull(toMarking, nameof(toMarking));
        Guard.NotNull(dist, nameof(dist));
        return this with
        {
            ToMarkingL = toMarking(ToMarkingL),
            ToMarkingM = toMarking(ToMarkingM),
            ToMarkingR = toMarking(ToMarkingR),
            ToMarkingLL = toMarking(ToMarkingLL),
            ToMarkingML = toMarking(ToMarkingML),
            ToMarkingMR = toMarking(ToMarkingMR),
            ToMarkingRR = toMarking(ToMarkingRR),
            DistL = dist(DistL),
            DistR = dist(DistR),
            DistLL = dist(DistLL),
            DistMM = dist(DistMM),
            DistRR = dist(DistRR),
        };
    }
}
