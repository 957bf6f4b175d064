namespace Harvester.Geometry.Lanes;

/// <summary>
/// The thirteen indicators of DeepDriving (Chen et al. 2015; Figure 15 of the thesis). Distances to markings are metres across the
/// road, negative to the left of the car and positive to the right. Distances to vehicles are metres along the road. Two systems
/// describe the car's position: in lane (LL, ML, MR, RR) while it is well within a lane, on marking (L, M, R) while it is near a
/// marking; between these limits both are active.
/// </summary>
public sealed record LaneIndicators
{
    /// <summary>
    /// Heading of the road minus that of the car, radians in (-pi, pi]; positive when the car points to the right of the road, as in TORCS.
    /// </summary>
    public Indicator Angle { get; init; }

    /// <summary>On marking: to the marking left of the one the car is on.</summary>
    public Indicator ToMarkingL { get; init; }

    /// <summary>On marking: to the marking the car is on.</summary>
    public Indicator ToMarkingM { get; init; }

    /// <summary>On marking: to the marking right of the one the car is on.</summary>
    public Indicator ToMarkingR { get; init; }

    /// <summary>On marking: to the nearest vehicle ahead in the lane left of the marking.</summary>
    public Indicator DistL { get; init; }

    /// <summary>On marking: to the nearest vehicle ahead in the lane right of the marking.</summary>
    public Indicator DistR { get; init; }

    /// <summary>In lane: to the left marking of the lane to the left.</summary>
    public Indicator ToMarkingLL { get; init; }

    /// <summary>In lane: to the left marking of the car's lane.</summary>
    public Indicator ToMarkingML { get; init; }

    /// <summary>In lane: to the right marking of the car's lane.</summary>
    public Indicator ToMarkingMR { get; init; }

    /// <summary>In lane: to the right marking of the lane to the right.</summary>
    public Indicator ToMarkingRR { get; init; }

    /// <summary>In lane: to the nearest vehicle ahead in the lane to the left.</summary>
    public Indicator DistLL { get; init; }

    /// <summary>In lane: to the nearest vehicle ahead in the car's lane.</summary>
    public Indicator DistMM { get; init; }

    /// <summary>In lane: to the nearest vehicle ahead in the lane to the right.</summary>
    public Indicator DistRR { get; init; }

    /// <summary>Every indicator at its inactive value.</summary>
    public static LaneIndicators Unknown { get; } = From(indicator => indicator.Range.Inactive);

    private LaneIndicators() { }

    /// <summary>Creates a set from a function that gives each indicator of <see cref="IndicatorTable"/>.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="indicatorOf"/> is null.</exception>
    public static LaneIndicators From(Func<IndicatorDefinition, Indicator> indicatorOf)
    {
        Guard.NotNull(indicatorOf, nameof(indicatorOf));
        return IndicatorTable.All.Aggregate(new LaneIndicators(), (set, indicator) => indicator.Replace(set, indicatorOf(indicator)));
    }

    /// <summary>
    /// The same set with one function applied to each distance to a marking and another to each distance to a vehicle: first all markings,
    /// then all vehicles, each in the order of <see cref="IndicatorTable"/>. The angle is unchanged.
    /// </summary>
    /// <param name="toMarking">Maps a distance to a marking, metres.</param>
    /// <param name="dist">Maps a distance to a vehicle, metres.</param>
    /// <exception cref="ArgumentNullException">A function is null.</exception>
    public LaneIndicators Select(Func<Indicator, Indicator> toMarking, Func<Indicator, Indicator> dist)
    {
        Guard.NotNull(toMarking, nameof(toMarking));
        Guard.NotNull(dist, nameof(dist));
        return Select(IndicatorQuantity.ToMarking, toMarking).Select(IndicatorQuantity.Dist, dist);
    }

    private LaneIndicators Select(IndicatorQuantity quantity, Func<Indicator, Indicator> map) =>
        IndicatorTable
            .All.Where(indicator => indicator.Quantity == quantity)
            .Aggregate(this, (set, indicator) => indicator.Replace(set, map(indicator.Of(set))));
}
