using Harvester.Capture.Ports;

namespace Harvester.Simulation.Traffic;

/// <summary>The physical limits of the driven ego: a heavy sports car on a dry road.</summary>
internal sealed record CarLimits
{
    /// <summary>Distance between the axles, metres.</summary>
    public double Wheelbase { get; init; } = 2.9;

    /// <summary>Distance of the car's origin from its rear axle, metres, positive ahead of it.</summary>
    public double OriginAheadOfRearAxle { get; init; } = 1.35;

    /// <summary>Angle of the front wheels at full lock, radians.</summary>
    public double SteeringLockRadians { get; init; } = CarTraits.UsualSteeringLockRadians;

    /// <summary>Maximum turning rate of the front wheels, radians per second.</summary>
    public double SteeringRate { get; init; } = 1.2;

    /// <summary>Acceleration at full throttle while the engine's power does not limit it, m/s².</summary>
    public double Acceleration { get; init; } = 4;

    /// <summary>Engine power per mass, W/kg.</summary>
    public double PowerPerMass { get; init; } = 100;

    /// <summary>Deceleration at full brake, m/s².</summary>
    public double Braking { get; init; } = 8;

    /// <summary>Air drag: deceleration divided by speed squared, 1/m.</summary>
    public double Drag { get; init; } = 0.0004;

    /// <summary>Rolling resistance: deceleration, m/s².</summary>
    public double RollingResistance { get; init; } = 0.12;

    /// <summary>Maximum acceleration by the tyres' grip, in all directions together, m/s².</summary>
    public double Grip { get; init; } = 8.8;

    /// <summary>The speed at which the car turns half as fast for the same wheel angle as at a crawl, m/s: it understeers.</summary>
    public double CharacteristicSpeed { get; init; } = 28;
}
