namespace Harvester.Geometry.Lanes;

/// <summary>Whether the lanes of a frame are known, and if not, why.</summary>
public enum LaneStatus
{
    /// <summary>No road is near.</summary>
    OffRoad,

    /// <summary>The car stands across the road or drives against its traffic.</summary>
    NotAlongRoad,

    /// <summary>The car follows a road but beside the lanes of its direction.</summary>
    BesideLanes,

    /// <summary>Two roads fit almost equally well.</summary>
    Ambiguous,

    /// <summary>In a junction no lanes are painted or defined.</summary>
    InJunction,

    /// <summary>The lanes are known.</summary>
    Known,
}
