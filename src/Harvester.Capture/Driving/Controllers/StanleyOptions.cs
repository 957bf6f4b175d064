namespace Harvester.Capture.Driving.Controllers;

/// <summary>The constants of <see cref="StanleyController"/>.</summary>
public sealed record StanleyOptions
{
    /// <summary>Gain of the lateral error, 1/s.</summary>
    public double LateralGain { get; init; } = 1.5;

    /// <summary>Added to the speed in the lateral term, so that it stays gentle at a crawl, m/s.</summary>
    public double SofteningSpeed { get; init; } = 2;

    /// <summary>Steering angle of the front wheels at full lock, radians.</summary>
    public double SteeringLockRadians { get; init; } = 0.6981317;

    /// <summary>Distance between the axles, metres.</summary>
    public double Wheelbase { get; init; } = 2.9;

    /// <summary>Speed on a free straight road, m/s.</summary>
    public double CruiseSpeed { get; init; } = 14;

    /// <summary>Sideways acceleration that a bend is taken with at most, m/s².</summary>
    public double LateralAcceleration { get; init; } = 2.5;

    /// <summary>Time kept to the vehicle ahead, seconds.</summary>
    public double TimeGap { get; init; } = 1.6;

    /// <summary>Distance kept to the vehicle ahead when standing, centre to centre, metres.</summary>
    public double StandingDistance { get; init; } = 9;

    /// <summary>Acceleration at most, m/s².</summary>
    public double Acceleration { get; init; } = 2;

    /// <summary>Comfortable braking, m/s².</summary>
    public double Braking { get; init; } = 3;

    /// <summary>Braking at full brake, m/s².</summary>
    public double FullBraking { get; init; } = 8;

    /// <summary>Weight of a new lateral measurement against the remembered one, 0 to 1; 1 trusts each frame.</summary>
    public double LateralSmoothing { get; init; } = 0.5;

    /// <summary>A vehicle ahead within so many seconds makes a free lane beside worth moving to.</summary>
    public double BlockedWithinSeconds { get; init; } = 3;
}
