using Harvester.Capture.Ports;

namespace Harvester.Driving.Controllers;

/// <summary>The constants of <see cref="StanleyController"/>.</summary>
public sealed record StanleyOptions
{
    /// <summary>The car.</summary>
    public CarTraits Car { get; init; } = new();

    /// <summary>Time between two frames, seconds.</summary>
    public double PeriodSeconds { get; init; } = 0.1;

    /// <summary>How far ahead the angle is measured, metres along the road.</summary>
    public double LookAheadMetres { get; init; } = 10;

    /// <summary>Gain of the lateral error, 1/s.</summary>
    public double LateralGain { get; init; } = 2.5;

    /// <summary>Added to the speed in the lateral term, so that it stays gentle at a crawl, m/s.</summary>
    public double SofteningSpeed { get; init; } = 2;

    /// <summary>A larger distance from the middle of the lane is steered against no more than this one, metres: a change of lane takes its time.</summary>
    public double LargestLateralError { get; init; } = 1.5;

    /// <summary>The car is not turned against its lane by more than this to get to the middle of it, radians: at a crawl it would turn across.</summary>
    public double LargestLateralAngle { get; init; } = 0.4;

    /// <summary>Weight of a new distance to the middle of the lane against the predicted one, 0 to 1; 1 trusts each frame.</summary>
    public double LateralWeight { get; init; } = 0.35;

    /// <summary>Time from a command to its effect, seconds: bends are steered for so much earlier.</summary>
    public double SteeringLeadSeconds { get; init; } = 0.2;

    /// <summary>Speed on a free straight road, m/s.</summary>
    public double CruiseSpeed { get; init; } = 14;

    /// <summary>Speed where the road does not run straight as far as is known, m/s.</summary>
    public double CautiousSpeed { get; init; } = 10;

    /// <summary>Sideways acceleration that a bend is taken with at most, m/s².</summary>
    public double LateralAcceleration { get; init; } = 2;

    /// <summary>Time kept to the vehicle ahead, seconds.</summary>
    public double TimeGap { get; init; } = 1.4;

    /// <summary>Distance kept to the vehicle ahead when standing, centre to centre, metres: room for the halves of a bus and of the car.</summary>
    public double StandingDistance { get; init; } = 12;

    /// <summary>Acceleration at most, m/s².</summary>
    public double Acceleration { get; init; } = 2;

    /// <summary>Comfortable braking, m/s².</summary>
    public double Braking { get; init; } = 2.5;

    /// <summary>Weight of a new acceleration against the one before, 0 to 1; 1 passes the noise of each frame to the pedals.</summary>
    public double PedalWeight { get; init; } = 0.4;

    /// <summary>A vehicle ahead within so many seconds makes a free lane beside worth moving to.</summary>
    public double BlockedWithinSeconds { get; init; } = 3;
}
