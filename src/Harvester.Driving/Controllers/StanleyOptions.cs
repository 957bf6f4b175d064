using Harvester.Capture.Ports;

namespace Harvester.Driving.Controllers;

/// <summary>The constants of <see cref="StanleyController"/>.</summary>
public sealed record StanleyOptions
{
    /// <summary>Steering lock, wheelbase and other traits of the driven car.</summary>
    public CarTraits Car { get; init; } = new();

    /// <summary>Time between two frames, seconds.</summary>
    public double PeriodSeconds { get; init; } = 0.1;

    /// <summary>Distance ahead at which the angle is measured, metres along the road.</summary>
    public double LookAheadMetres { get; init; } = 10;

    /// <summary>Gain of the lateral error, 1/s.</summary>
    public double LateralGain { get; init; } = 2.5;

    /// <summary>Added to the speed in the lateral term, so that it stays gentle at a crawl, m/s.</summary>
    public double SofteningSpeed { get; init; } = 2;

    /// <summary>Maximum lateral error that is corrected, metres, so that a lane change is not abrupt.</summary>
    public double MaxLateralError { get; init; } = 1.5;

    /// <summary>
    /// Maximum heading relative to the lane when steering to its centre, radians; at low speed the car would otherwise turn across.
    /// </summary>
    public double MaxLateralAngle { get; init; } = 0.4;

    /// <summary>Weight of a measured lateral error against the predicted one, 0 to 1; 1 uses the measured one only.</summary>
    public double LateralWeight { get; init; } = 0.35;

    /// <summary>Delay between a steering command and its effect, seconds; steering for bends starts this much earlier.</summary>
    public double SteeringLeadSeconds { get; init; } = 0.2;

    /// <summary>Speed on a free straight road, m/s.</summary>
    public double CruiseSpeed { get; init; } = 14;

    /// <summary>Speed if the road is not known to be straight, m/s.</summary>
    public double CautiousSpeed { get; init; } = 10;

    /// <summary>Maximum lateral acceleration in bends, m/s².</summary>
    public double LateralAcceleration { get; init; } = 2;

    /// <summary>Time gap to the vehicle ahead, seconds.</summary>
    public double TimeGap { get; init; } = 1.4;

    /// <summary>
    /// Distance to the vehicle ahead at a standstill, centre to centre, metres: room for half of a bus and half of the car.
    /// </summary>
    public double StandingDistance { get; init; } = 12;

    /// <summary>Maximum acceleration, m/s².</summary>
    public double Acceleration { get; init; } = 2;

    /// <summary>Comfortable deceleration, m/s², greater than 0.</summary>
    public double Braking { get; init; } = 2.5;

    /// <summary>Weight of a new acceleration against the one before, 0 to 1; 1 passes the noise of each frame to the pedals.</summary>
    public double PedalWeight { get; init; } = 0.4;

    /// <summary>Maximum time gap to a vehicle ahead at which the car moves to a free neighbouring lane, seconds.</summary>
    public double BlockedWithinSeconds { get; init; } = 3;
}
