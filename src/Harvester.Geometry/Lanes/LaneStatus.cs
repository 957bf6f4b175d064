namespace Harvester.Geometry.Lanes;

/// <summary>Whether the lanes of a frame are known, and if not, why.</summary>
public enum LaneStatus
{
    /// <summary>There is no road nearby.</summary>
    OffRoad,

    /// <summary>The car is at an angle to the road or drives against its traffic.</summary>
    NotAlongRoad,

    /// <summary>The car follows a road but is outside the lanes of its direction.</summary>
    BesideLanes,

    /// <summary>Two roads fit almost equally well.</summary>
    Ambiguous,

    /// <summary>The car is in a junction, where no lanes are painted or defined.</summary>
    InJunction,

    /// <summary>The lanes are known.</summary>
    Known,
}
