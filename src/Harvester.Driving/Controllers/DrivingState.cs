using Harvester.Geometry.Lanes;
using Harvester.Sessions.Scenes;

namespace Harvester.Driving.Controllers;

/// <summary>The input of a controller at one moment.</summary>
/// <param name="Indicators">The indicators in metres on the road as it is.</param>
/// <param name="TorcsEquivalent">The indicators that a road of TORCS would give, with the angle at the car.</param>
/// <param name="IsFast">Whether more than 60 m of straight road lie ahead.</param>
/// <param name="SpeedMetresPerSecond">The car's speed, m/s; 0 or more.</param>
public sealed record DrivingState(LaneIndicators Indicators, LaneIndicators TorcsEquivalent, bool IsFast, double SpeedMetresPerSecond)
{
    /// <summary>The car's heading, radians, increasing to the left, from an arbitrary zero; null if unknown.</summary>
    public double? HeadingRadians { get; init; }

    /// <summary>
    /// Throttle and brake that have moved the car since the previous moment, each 0 to 1; null if unknown. They are not the controller's
    /// own where somebody else has driven.
    /// </summary>
    public (double Throttle, double Brake)? PedalsInForce { get; init; }

    /// <summary>The pedals that a car reports; null if it does not.</summary>
    public static (double Throttle, double Brake)? PedalsOf(EgoState ego) =>
        ego?.Motion is { Throttle: { } throttle, Brake: { } brake } ? (throttle, brake) : null;
}
