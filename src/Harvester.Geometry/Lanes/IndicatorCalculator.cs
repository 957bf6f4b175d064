using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Lanes;

/// <summary>
/// Computes the indicators from the car's position on its road. The rules of activation are those of DeepDriving's driver for TORCS; their
/// thresholds, given for lanes 4 metres wide, are scaled with the lane.
/// </summary>
public static class IndicatorCalculator
{
    /// <summary>Maximum distance of a vehicle that counts, metres: the thesis's range, and the value if there is no vehicle.</summary>
    public const double VehicleRange = 70;

    // Metres for lanes 4 m wide: the car is in its lane up to 1.5 m from the centre, and on a marking from 1 m or 1.2 m of it, so that both
    // systems of indicators are valid together for 0.5 m or 0.7 m. IndicatorCalculatorTests holds both borders.
    private const double InLaneReach = 1.5;
    private const double MarkingReachOfThreeLanes = 1.0;
    private const double MarkingReachOfFewerLanes = 1.2;

    /// <summary>Computes the thirteen indicators of one moment; those that do not apply are inactive.</summary>
    /// <param name="angle">Heading of the road minus that of the car, radians.</param>
    /// <param name="offset">The car's position across the road, metres to the right of the left edge of the leftmost lane.</param>
    /// <param name="section">The lanes of the car's direction.</param>
    /// <param name="vehicles">Vehicles in these lanes; those behind or beyond <see cref="VehicleRange"/> are ignored.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite.</exception>
    public static LaneIndicators Compute(double angle, double offset, LaneSection section, IReadOnlyList<VehicleAhead> vehicles)
    {
        Guard.Finite(offset, nameof(offset));
        Guard.NotNull(vehicles, nameof(vehicles));
        LaneIndicators indicators = LaneIndicators.Unknown with { Angle = Indicator.Of(Angles.WrapRadians(angle)) };
        indicators = WithInLane(indicators, offset, section, vehicles);
        return WithOnMarking(indicators, offset, section, vehicles);
    }

    private static LaneIndicators WithInLane(
        LaneIndicators indicators,
        double offset,
        LaneSection section,
        IReadOnlyList<VehicleAhead> vehicles
    )
    {
        if (section.LaneAt(offset) is not { } lane)
        {
            return indicators;
        }

        // The car is in its lane while its distance from the lane's centre, scaled to a lane of 4 m, is at most InLaneReach.
        double fromCentre = offset - section.MiddleOf(lane);
        if (Math.Abs(fromCentre) * LaneSection.TorcsLaneWidth / section.WidthOf(lane) > InLaneReach)
        {
            return indicators;
        }

        bool hasLeft = lane > 0;
        bool hasRight = lane < section.LaneCount - 1;
        return indicators with
        {
            ToMarkingLL = hasLeft ? ToMarking(lane - 1, offset, section) : indicators.ToMarkingLL,
            ToMarkingML = ToMarking(lane, offset, section),
            ToMarkingMR = ToMarking(lane + 1, offset, section),
            ToMarkingRR = hasRight ? ToMarking(lane + 2, offset, section) : indicators.ToMarkingRR,
            DistLL = hasLeft ? Nearest(lane - 1, vehicles) : indicators.DistLL,
            DistMM = Nearest(lane, vehicles),
            DistRR = hasRight ? Nearest(lane + 1, vehicles) : indicators.DistRR,
        };
    }

    private static LaneIndicators WithOnMarking(
        LaneIndicators indicators,
        double offset,
        LaneSection section,
        IReadOnlyList<VehicleAhead> vehicles
    )
    {
        // The nearest marking k, 0 at the left edge of the road, and the car's distance from it, scaled to a lane of 4 m.
        int marking = section.NearestEdge(offset);
        double laneWidth = section.WidthOf(section.NearestLane(offset));
        double toTheRight = (offset - section.Edge(marking)) * LaneSection.TorcsLaneWidth / laneWidth;
        double reach = section.LaneCount >= 3 ? MarkingReachOfThreeLanes : MarkingReachOfFewerLanes;
        bool hasLeft = marking > 0;
        bool hasRight = marking < section.LaneCount;
        double reachLeft = hasLeft ? reach : LaneSection.ReachOutsideTheRoad;
        double reachRight = hasRight ? reach : LaneSection.ReachOutsideTheRoad;
        if (toTheRight < -reachLeft || toTheRight > reachRight)
        {
            return indicators;
        }

        return indicators with
        {
            ToMarkingL = hasLeft ? ToMarking(marking - 1, offset, section) : indicators.ToMarkingL,
            ToMarkingM = ToMarking(marking, offset, section),
            ToMarkingR = hasRight ? ToMarking(marking + 1, offset, section) : indicators.ToMarkingR,
            DistL = hasLeft ? Nearest(marking - 1, vehicles) : indicators.DistL,
            DistR = hasRight ? Nearest(marking, vehicles) : indicators.DistR,
        };
    }

    // Distances to markings are positive to the right.
    private static Indicator ToMarking(int marking, double offset, LaneSection section) => Indicator.Of(section.Edge(marking) - offset);

    private static Indicator Nearest(int lane, IReadOnlyList<VehicleAhead> vehicles)
    {
        double nearest = VehicleRange;
        foreach (VehicleAhead vehicle in vehicles)
        {
            if (vehicle.Lane == lane && vehicle.Distance > 0)
            {
                nearest = Math.Min(nearest, vehicle.Distance);
            }
        }

        return Indicator.Of(nearest);
    }
}
