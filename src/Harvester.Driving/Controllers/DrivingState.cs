using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Controllers;

/// <summary>What a controller knows at one moment.</summary>
/// <param name="Indicators">The indicators in metres on the road as it is.</param>
/// <param name="TorcsEquivalent">The same as a road of TORCS would give them, with the angle at the car.</param>
/// <param name="IsFast">Whether more than 60 m of straight road lie ahead.</param>
/// <param name="SpeedMetresPerSecond">The car's speed, m/s; 0 or more.</param>
public sealed record DrivingState(
    LaneIndicators Indicators,
    LaneIndicators TorcsEquivalent,
    bool IsFast,
    double SpeedMetresPerSecond)
{
    /// <summary>Where the car points, radians, growing to the left from any zero; null when unknown.</summary>
    public double? HeadingRadians { get; init; }
}
