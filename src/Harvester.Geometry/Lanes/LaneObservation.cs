using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Lanes;

/// <summary>The lanes around a car at one moment.</summary>
public sealed record LaneObservation
{
    /// <summary>Whether the lanes are known. If not, all indicators are inactive and no vehicles are assigned to lanes.</summary>
    public required LaneStatus Status { get; init; }

    /// <summary>Where the car is on the network.</summary>
    public required RoadMatch Match { get; init; }

    /// <summary>The road behind and ahead; null without a road.</summary>
    public RoadStretch? Stretch { get; init; }

    /// <summary>
    /// Where the lane width comes from: at the car and, if it is measured there, at the look-ahead point too; null without a road.
    /// </summary>
    public LaneWidthSource? WidthSource { get; init; }

    /// <summary>
    /// How far ahead <see cref="Indicators"/> are measured, metres along the road; less than requested if the road ends before.
    /// </summary>
    public double LookAheadMetres { get; init; }

    /// <summary>The lanes at the look-ahead point.</summary>
    public LaneSection? Section { get; init; }

    /// <summary>The car's position, metres to the right of the left edge of the lanes at the look-ahead point; 0 if unknown.</summary>
    public double OffsetFromLeftEdge { get; init; }

    /// <summary>The indicators measured at the look-ahead point.</summary>
    public LaneIndicators Indicators { get; init; } = LaneIndicators.Unknown;

    /// <summary>The lanes at the car.</summary>
    public LaneSection? SectionAtCar { get; init; }

    /// <summary>The indicators measured at the car itself.</summary>
    public LaneIndicators IndicatorsAtCar { get; init; } = LaneIndicators.Unknown;

    /// <summary>Curvature of the road at the look-ahead point, 1/metres, positive to the left; 0 if unknown.</summary>
    public double CurvaturePerMetre { get; init; }

    /// <summary>Whether more than 60 m of straight road lie ahead: DeepDriving's fourteenth value.</summary>
    public bool IsFast { get; init; }

    /// <summary>Vehicles ahead on the same road, nearest first.</summary>
    public IReadOnlyList<VehicleInLane> Vehicles { get; init; } = [];
}
