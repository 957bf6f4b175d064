using System;
using Harvester.Geometry.Lanes;

namespace Harvester.Capture.Driving.Controllers;

/// <summary>
/// Steers by Stanley's law on the centre of the lane (wheel angle = heading error + atan(k · lateral error / speed), with the road's
/// curvature fed forward), keeps a time gap to the vehicle ahead by the intelligent driver model, and moves to a free lane when a
/// slower vehicle blocks its own. Uses all thirteen indicators, in metres, with their valid flags.
/// </summary>
public sealed class StanleyController : IController
{
    private const int FramesToClear = 30;
    private readonly StanleyOptions _options;
    private readonly LaneTarget _lane = new();
    private readonly LaneClearance _left = new();
    private readonly LaneClearance _right = new();
    private double? _centre;
    private double? _gap;

    /// <summary>Makes a controller.</summary>
    public StanleyController(StanleyOptions options)
    {
        _options = options ?? throw new ArgumentNullException(nameof(options));
    }

    /// <inheritdoc/>
    public DrivingControls Drive(DrivingState state)
    {
        _ = state ?? throw new ArgumentNullException(nameof(state));
        LaneIndicators at = state.Indicators;
        _left.Observe(at.DistLL.Value);
        _right.Observe(at.DistRR.Value);
        ObserveGap(at);
        ConsiderLaneChange(state);
        ObserveCentre(at);
        double steering = Steering(state);
        double acceleration = Acceleration(state);
        return acceleration >= 0
            ? new DrivingControls(steering, acceleration / _options.Acceleration, 0)
            : new DrivingControls(steering, 0, -acceleration / _options.FullBraking);
    }

    private void ObserveCentre(LaneIndicators at)
    {
        double? centre = _lane.Centre(at);
        double laneWidth = at.ToMarkingMR.Value - at.ToMarkingML.Value;
        bool jumped = centre is { } now && _centre is { } before && Math.Abs(now - before) > laneWidth / 2;
        _centre = centre is null ? null
            : _centre is null || jumped ? centre
            : _centre + (_options.LateralSmoothing * (centre - _centre));
    }

    /// <summary>Noise on a distance is evened out, but a vehicle that comes nearer is believed at once.</summary>
    private void ObserveGap(LaneIndicators at)
    {
        Indicator nearest = at.DistMM.IsValid ? at.DistMM
            : at.DistL.IsValid && at.DistR.IsValid ? Indicator.Of(Math.Min(at.DistL.Value, at.DistR.Value))
            : at.DistL.IsValid ? at.DistL
            : at.DistR;
        double? measured = nearest.IsValid && nearest.Value < IndicatorCalculator.VehicleRange ? nearest.Value : null;
        const double smoothing = 0.4;
        _gap = measured is { } now && _gap is { } before && Math.Abs(now - before) < 12
            ? before + (smoothing * (now - before))
            : measured;
    }

    private void ConsiderLaneChange(DrivingState state)
    {
        LaneIndicators at = state.Indicators;
        double blockedWithin = Math.Max(20, state.SpeedMetresPerSecond * _options.BlockedWithinSeconds);
        if (_lane.BoundFor != 0 || !(_gap < blockedWithin) || state.SpeedMetresPerSecond > 0.9 * _options.CruiseSpeed)
        {
            return;
        }

        if (at.ToMarkingLL.IsValid && _left.IsClear(FramesToClear) && at.DistLL.Value > _gap + 15)
        {
            _lane.MoveTo(-1);
            _right.Restart(0);
        }
        else if (at.ToMarkingRR.IsValid && _right.IsClear(FramesToClear) && at.DistRR.Value > _gap + 15)
        {
            _lane.MoveTo(1);
            _left.Restart(0);
        }
    }

    private double Steering(DrivingState state)
    {
        double angle = state.Indicators.Angle.IsValid ? state.Indicators.Angle.Value : 0;
        double lateral = Math.Atan2(-_options.LateralGain * (_centre ?? 0), state.SpeedMetresPerSecond + _options.SofteningSpeed);
        double curve = Math.Atan(_options.Wheelbase * state.CurvaturePerMetre);
        return (angle + lateral + curve) / _options.SteeringLockRadians;
    }

    /// <summary>The intelligent driver model: free acceleration less an interaction with the vehicle ahead.</summary>
    private double Acceleration(DrivingState state)
    {
        double speed = state.SpeedMetresPerSecond;
        double bend = Math.Abs(state.CurvaturePerMetre);
        double wanted = bend > 0 ? Math.Min(_options.CruiseSpeed, Math.Sqrt(_options.LateralAcceleration / bend)) : _options.CruiseSpeed;
        double acceleration = _options.Acceleration * (1 - Math.Pow(speed / wanted, 4));
        if (_gap is { } gap)
        {
            double kept = _options.StandingDistance + (speed * _options.TimeGap);
            double room = Math.Max(0.5, gap);
            acceleration -= _options.Acceleration * (kept / room) * (kept / room);
        }

        return Math.Max(-_options.FullBraking, Math.Min(_options.Acceleration, acceleration));
    }
}
