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
    private const int FramesToClear = 30;

    /// <summary>
    /// Minimum advantage of the neighbouring lane for a lane change: how much farther it must be free than the car's own, metres.
    /// </summary>
    private const double GainOfLane = 15;

    /// <summary>Minimum speed for a lane change, m/s: in a queue, a lane change would end across the marking.</summary>
    private const double SlowestToChange = 3;

    /// <summary>Wanted deceleration from which the resistance no longer reduces the braking, m/s².</summary>
    private const double FullyBrakes = 1;
    private const double BendStep = 2;
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
        double laneWidth = at.ToMarkingMR.Value - at.ToMarkingML.Value;
        bool jumped = measured is { } there && predicted is { } expected && Math.Abs(there - expected) > laneWidth / 2;
        _centre =
            measured is null || predicted is null || jumped ? measured : predicted + (_options.LateralWeight * (measured - predicted));
    }

    private void ConsiderLaneChange(DrivingState state)
    {
        LaneIndicators at = state.Indicators;
        double blockedWithin = Math.Max(20, state.SpeedMetresPerSecond * _options.BlockedWithinSeconds);
        if (
            _lane.BoundFor != 0
            || !(_leader.Gap < blockedWithin)
            || state.SpeedMetresPerSecond < SlowestToChange
            || state.SpeedMetresPerSecond > 0.9 * _options.CruiseSpeed
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
        double free =
            speed <= wanted
                ? _options.Acceleration * (1 - Math.Pow(speed / wanted, 4))
                : -Math.Min(_options.Car.FullBraking, 2 * (speed - wanted));
        if (_leader.Gap is { } gap)
        {
            double closing = speed * (speed - _leader.Speed) / (2 * Math.Sqrt(_options.Acceleration * _options.Braking));
            double kept = _options.StandingDistance + Math.Max(0, (speed * _options.TimeGap) + closing);
            double share = kept / Math.Max(0.5, gap);
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
            double bend = Math.Max(1e-6, Math.Abs(_road.At(ahead).Curvature));
            wanted = Math.Min(wanted, Math.Sqrt((_options.LateralAcceleration / bend) + (2 * _options.Braking * ahead)));
        }

        return wanted;
    }
}
