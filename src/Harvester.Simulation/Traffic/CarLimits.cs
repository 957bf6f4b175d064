using Harvester.Capture.Ports;

namespace Harvester.Simulation.Traffic;

/// <summary>What the ego can do when it is driven: a heavy sports car on a dry road.</summary>
internal sealed record CarLimits
{
    /// <summary>Distance between the axles, metres.</summary>
    public double Wheelbase { get; init; } = 2.9;

    /// <summary>How far the car's origin lies ahead of its rear axle, metres.</summary>
    public double OriginAheadOfRearAxle { get; init; } = 1.35;

    /// <summary>Angle of the front wheels at full lock, radians.</summary>
    public double SteeringLockRadians { get; init; } = CarTraits.UsualSteeringLockRadians;

    /// <summary>How fast the front wheels turn at most, radians per second.</summary>
    public double SteeringRate { get; init; } = 1.2;

    /// <summary>Acceleration at full throttle while the engine's power does not limit it, m/s².</summary>
    public double Acceleration { get; init; } = 4;

    /// <summary>Power of the engine by mass, W/kg.</summary>
    public double PowerPerMass { get; init; } = 100;

    /// <summary>Deceleration at full brake, m/s².</summary>
    public double Braking { get; init; } = 8;

    /// <summary>Deceleration by the air, by speed squared, 1/m.</summary>
    public double Drag { get; init; } = 0.0004;

    /// <summary>Deceleration by the tyres' rolling, m/s².</summary>
    public double RollingResistance { get; init; } = 0.12;

    /// <summary>Acceleration that the tyres can pass to the road, in all directions together, m/s².</summary>
    public double Grip { get; init; } = 8.8;

    /// <summary>The speed at which the car turns half as fast for the same wheel angle as at a crawl, m/s: it understeers.</summary>
    public double CharacteristicSpeed { get; init; } = 28;
}
