namespace Harvester.Capture.Ports;

/// <summary>
/// What a controller needs to know of the car that it drives. The values are those of the simulated car. The game's vehicles turn their
/// wheels by 35 to 45 degrees, most by about 40, which other programs that drive in GTA V also use as full lock.
/// </summary>
public sealed record CarTraits
{
    /// <summary>Angle of the front wheels at full lock, radians: 40 degrees.</summary>
    public const double UsualSteeringLockRadians = 0.6981317;

    /// <summary>Angle of the front wheels at full lock, radians.</summary>
    public double SteeringLockRadians { get; init; } = UsualSteeringLockRadians;

    /// <summary>Turning rate of the front wheels, radians per second.</summary>
    public double SteeringRate { get; init; } = 1.2;

    /// <summary>Distance between the axles, metres.</summary>
    public double Wheelbase { get; init; } = 2.9;

    /// <summary>The speed at which the car turns half as fast for the same wheel angle as at a crawl, m/s.</summary>
    public double CharacteristicSpeed { get; init; } = 28;

    /// <summary>Acceleration at full throttle, m/s².</summary>
    public double FullThrottle { get; init; } = 4;

    /// <summary>Braking at full brake, m/s².</summary>
    public double FullBraking { get; init; } = 8;

    /// <summary>Factor by which the wheels have to turn more at a speed than at a crawl for the same bend.</summary>
    public double UndersteerAt(double speed) => 1 + (speed * speed / (CharacteristicSpeed * CharacteristicSpeed));
}
