namespace Harvester.Geometry.Roads;

/// <summary>Whether a car's road and lane are known, and if not, why.</summary>
public enum RoadMatchOutcome
{
    /// <summary>No road is near, at the height of the car.</summary>
    NoRoadNear,

    /// <summary>The roads near are not driven in the car's direction: it stands across them, or drives against one-way traffic.</summary>
    NotAlongAnyRoad,

    /// <summary>The car follows a road but is beside the lanes of its direction: on the other side, the median or the verge.</summary>
    BesideTheLanes,

    /// <summary>Two roads fit almost equally well.</summary>
    Ambiguous,

    /// <summary>Road and lane are known.</summary>
    Matched,
}
