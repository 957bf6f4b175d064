namespace Harvester.Geometry.Lanes;

/// <summary>What an indicator measures; this also gives its unit.</summary>
public enum IndicatorQuantity
{
    /// <summary>The angle between road and car, radians.</summary>
    Angle,

    /// <summary>The distance to a marking, metres across the road; negative to the left of the car.</summary>
    ToMarking,

    /// <summary>The distance to a vehicle ahead, metres along the road.</summary>
    Dist,
}
