using Harvester.Capture.Ports;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;

namespace Harvester.Driving.Controllers;

/// <summary>
/// Steers by Stanley's law towards the centre of the lane (wheel angle = heading error + atan(k · lateral error / speed), with the road's
/// curvature fed forward), keeps a time gap to the vehicle ahead by the intelligent driver model, and moves to a free lane if a slower
/// vehicle blocks its own. Uses all thirteen indicators, in metres, with their valid flags. The angle at the car and the bends ahead are
/// derived from the angles measured ahead and from how the car has turned since.
/// </summary>
public sealed class StanleyController : IAimingController
{
    /// <summary>Number of frames for which the neighbouring lane must have been free: 3 s at 0.1 s.</summary>
    private const int FramesToClear = 30;

    /// <summary>
    /// Minimum advantage of the neighbouring lane for a lane change: how much farther it must be free than the car's own, metres.
    /// </summary>
    private const double GainOfLane = 15;

    /// <summary>Minimum speed for a lane change, m/s: in a queue, a lane change would end across the marking.</summary>
    private const double SlowestToChange = 3;

    /// <summary>Wanted deceleration from which the resistance no longer reduces the braking, m/s².</summary>
    private const double FullyBrakes = 1;

    /// <summary>Distance between the points ahead at which the bend limits the speed, metres.</summary>
    private const double BendStep = 2;

    /// <summary>
    /// A vehicle nearer than this blocks the lane at any speed, metres: at low speed the distance by time would be less than what cars keep
    /// to each other when they stand.
    /// </summary>
    private const double MinBlockedWithin = 20;

    /// <summary>From this fraction of the cruise speed on, the vehicle ahead does not hold the car up.</summary>
    private const double HardlyHeldUp = 0.9;

    /// <summary>Exponent of the free acceleration, δ = 4 in Treiber, Hennecke and Helbing (2000).</summary>
    private const double FreeExponent = 4;

    /// <summary>Deceleration per speed over the wanted one, 1/s. The free term of the model would brake with the fourth power.</summary>
    private const double ExcessGain = 2;

    /// <summary>
    /// Minimum of the gap in the interaction term, metres: the estimate may be 0 or less, and the pedals are limited anyway.
    /// </summary>
    private const double MinGap = 0.5;

    /// <summary>Minimum curvature by which the speed in bends is divided, 1/m: a radius of 1,000 km, which limits no speed.</summary>
    private const double MinBend = 1e-6;
    private readonly StanleyOptions _options;
    private readonly LaneTarget _lane = new();
    private readonly LaneClearance _left = new();
    private readonly LaneClearance _right = new();
    private readonly LeaderEstimate _leader = new();
    private readonly ResistanceEstimate _resistance = new();
    private readonly RoadAhead _road;
    private double? _centre;
    private double _acceleration;

    /// <summary>Creates a controller with no memory of the road.</summary>
    public StanleyController(StanleyOptions options)
    {
        _options = options ?? throw new ArgumentNullException(nameof(options));
        _road = new RoadAhead(options.LookAheadMetres, options.PeriodSeconds, options.Car);
    }

    /// <summary>The speed that the road allows, without regard to vehicles, and the middle of the lane to drive in.</summary>
    public DriveTarget? Target { get; private set; }

    /// <inheritdoc/>
    public DrivingControls Drive(DrivingState state)
    {
        _ = state ?? throw new ArgumentNullException(nameof(state));
        LaneIndicators at = state.Indicators;
        _left.Observe(at.DistLL.Value);
        _right.Observe(at.DistRR.Value);
        _road.Observe(state);
        _leader.Observe(at, state.SpeedMetresPerSecond, _options.PeriodSeconds);
        ConsiderLaneChange(state);
        ObserveCentre(at, state.SpeedMetresPerSecond);
        Target = new DriveTarget(TargetSpeed(state), _centre);
        double wheelAngle = WheelAngle(state.SpeedMetresPerSecond);
        _road.RequestedWheelAngle = wheelAngle;
        _acceleration += _options.PedalWeight * (Acceleration(state) - _acceleration);
        double steering = wheelAngle / _options.Car.SteeringLockRadians;
        double asked = Against(state, _acceleration);
        return asked >= 0
            ? new DrivingControls(steering, asked / _options.Car.FullThrottle, 0)
            : new DrivingControls(steering, 0, -asked / _options.Car.FullBraking);
    }

    /// <summary>What the pedals have to give for an acceleration against the resistance, m/s².</summary>
    private double Against(DrivingState state, double acceleration)
    {
        double? inForce = state.PedalsInForce is { } pedals
            ? (pedals.Throttle * _options.Car.FullThrottle) - (pedals.Brake * _options.Car.FullBraking)
            : null;
        _resistance.Observe(state.SpeedMetresPerSecond, _options.PeriodSeconds, inForce);

        // 1 while accelerating, falling linearly to 0 at a deceleration of FullyBrakes: the resistance helps to brake.
        double share = Math.Max(0, Math.Min(1, 1 + (acceleration / FullyBrakes)));
        double asked = Math.Min(_options.Car.FullThrottle, acceleration + (share * _resistance.Value));
        _resistance.Ask(asked);
        return asked;
    }

    private void ObserveCentre(LaneIndicators at, double speed)
    {
        // If the car points to the right of the road, it moves to the right, and the middle of the lane moves to its left.
        double? predicted = _centre - (speed * _options.PeriodSeconds * Math.Sin(_road.At(0).Angle));
        double? measured = _lane.Centre(at);

        // First-order filter: predicted + weight · (measured - predicted). A difference of more than half a lane is another lane, not
        // noise.
        double laneWidth = at.ToMarkingMR.Value - at.ToMarkingML.Value;
        bool jumped = measured is { } there && predicted is { } expected && Math.Abs(there - expected) > laneWidth / 2;
        _centre =
            measured is null || predicted is null || jumped ? measured : predicted + (_options.LateralWeight * (measured - predicted));
    }

    private void ConsiderLaneChange(DrivingState state)
    {
        LaneIndicators at = state.Indicators;
        double blockedWithin = Math.Max(MinBlockedWithin, state.SpeedMetresPerSecond * _options.BlockedWithinSeconds);
        if (
            _lane.BoundFor != 0
            || !(_leader.Gap < blockedWithin)
            || state.SpeedMetresPerSecond < SlowestToChange
            || state.SpeedMetresPerSecond > HardlyHeldUp * _options.CruiseSpeed
        )
        {
            return;
        }

        if (at.ToMarkingLL.IsValid && _left.IsClear(FramesToClear) && at.DistLL.Value > _leader.Gap + GainOfLane)
        {
            _lane.MoveTo(-1);
            _right.Restart(0);
        }
        else if (at.ToMarkingRR.IsValid && _right.IsClear(FramesToClear) && at.DistRR.Value > _leader.Gap + GainOfLane)
        {
            _lane.MoveTo(1);
            _left.Restart(0);
        }
    }

    private double WheelAngle(double speed)
    {
        double angle = _road.At(0).Angle;

        // Stanley's law (Hoffmann, Tomlin, Montemerlo and Thrun 2007): heading error + atan(k e / (k_soft + v)) + wheel angle for the bend.
        // The middle of the lane to the right of the car, e > 0, turns the wheels to the right, which is negative.
        double error = Math.Max(-_options.MaxLateralError, Math.Min(_options.MaxLateralError, _centre ?? 0));
        double lateral = Math.Atan2(-_options.LateralGain * error, speed + _options.SofteningSpeed);
        lateral = Math.Max(-_options.MaxLateralAngle, Math.Min(_options.MaxLateralAngle, lateral));
        return angle + lateral + _road.WheelAngleAt(speed * _options.SteeringLeadSeconds, speed);
    }

    /// <summary>The intelligent driver model: free acceleration minus an interaction with the vehicle ahead.</summary>
    private double Acceleration(DrivingState state)
    {
        double speed = state.SpeedMetresPerSecond;
        double wanted = TargetSpeed(state);

        // a (1 - (v / v0)^4) up to the wanted speed; above it, braking in proportion to the excess.
        double free =
            speed <= wanted
                ? _options.Acceleration * (1 - Math.Pow(speed / wanted, FreeExponent))
                : -Math.Min(_options.Car.FullBraking, ExcessGain * (speed - wanted));
        if (_leader.Gap is { } gap)
        {
            // s* = s0 + max(0, v T + v Δv / (2 √(a b))), and the interaction is a (s* / s)².
            double closing = speed * (speed - _leader.Speed) / (2 * Math.Sqrt(_options.Acceleration * _options.Braking));
            double kept = _options.StandingDistance + Math.Max(0, (speed * _options.TimeGap) + closing);
            double share = kept / Math.Max(MinGap, gap);
            free -= _options.Acceleration * share * share;
        }

        return Math.Max(-_options.Car.FullBraking, Math.Min(_options.Acceleration, free));
    }

    /// <summary>The speed that the road allows: the speed of a bend ahead is reached by comfortable braking.</summary>
    private double TargetSpeed(DrivingState state)
    {
        double wanted = state.IsFast ? _options.CruiseSpeed : _options.CautiousSpeed;
        for (double ahead = 0; ahead <= _options.LookAheadMetres; ahead += BendStep)
        {
            // In the bend v² κ ≤ lateral acceleration; at a distance s before it, v² = a_lat / κ + 2 b s.
            double bend = Math.Max(MinBend, Math.Abs(_road.At(ahead).Curvature));
            wanted = Math.Min(wanted, Math.Sqrt((_options.LateralAcceleration / bend) + (2 * _options.Braking * ahead)));
        }

        return wanted;
    }
}
