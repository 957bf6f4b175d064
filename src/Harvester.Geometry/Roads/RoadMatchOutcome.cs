namespace Harvester.Geometry.Roads;

/// <summary>Whether a car's road and lane are known, and if not, why.</summary>
public enum RoadMatchOutcome
{
    /// <summary>No road is nearby at the height of the car.</summary>
    NoRoadNear,

    /// <summary>
    /// No road nearby is driven in the car's direction: the car is at an angle to them, or drives against one-way traffic.
    /// </summary>
    NotAlongAnyRoad,

    /// <summary>The car follows a road but is outside the lanes of its direction: on the other side, the median or the verge.</summary>
    BesideTheLanes,

    /// <summary>Two roads fit almost equally well.</summary>
    Ambiguous,

    /// <summary>Road and lane are known.</summary>
    Matched,
}
