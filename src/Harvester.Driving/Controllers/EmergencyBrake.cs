using Harvester.Capture.Ports;
using Harvester.Sessions.Labels;

namespace Harvester.Driving.Controllers;

/// <summary>
/// Brakes for a controller that does not brake enough. If reaching the speed of the vehicle ahead at a distance of <see
/// cref="StandingDistance"/> takes more than comfortable braking, v² - v'² over twice the remaining distance, it brakes by exactly that;
/// nearer than that, it does not let the car approach a vehicle. Steering, and until then the pedals, are the controller's. A vehicle that
/// comes into sight is assumed to stand still until it is seen to move.
/// </summary>
public sealed class EmergencyBrake : IAimingController
{
    /// <summary>Distance to the vehicle ahead, centre to centre, metres: room for half of a bus and half of the car.</summary>
    public const double StandingDistance = 11;

    /// <summary>Deceleration from which it intervenes, m/s².</summary>
    public const double Comfortable = 2;

    /// <summary>
    /// Deceleration down to which it goes on once it has intervened, m/s²: with one limit, the noise of each frame would swap the brake for
    /// the controller's throttle and back.
    /// </summary>
    private const double Gentle = 1;

    private const double PeriodSeconds = 0.1;

    /// <summary>Minimum of the remaining distance in the formula, metres.</summary>
    private const double MinDistance = 1;

    private readonly IController _controller;
    private readonly CarTraits _car;
    private readonly LeaderEstimate _leader = new(speedOfNewcomers: 0);
    private bool _isBraking;

    /// <summary>Adds the brake to a controller.</summary>
    public EmergencyBrake(IController controller, CarTraits car)
    {
        _controller = controller ?? throw new ArgumentNullException(nameof(controller));
        _car = car ?? throw new ArgumentNullException(nameof(car));
    }

    /// <summary>What the controller aims at, also while the brake overrides it.</summary>
    public DriveTarget? Target => (_controller as IAimingController)?.Target;

    /// <inheritdoc/>
    public DrivingControls Drive(DrivingState state)
    {
        DrivingControls controls = _controller.Drive(state);
        double speed = state.SpeedMetresPerSecond;
        _leader.Observe(state.Indicators, speed, PeriodSeconds);
        if (_leader.Gap is not { } gap)
        {
            _isBraking = false;
            return controls;
        }

        // Deceleration from v to v' over the way that is left: (v² - v'²) / (2 · way). Without any left, at least twice the comfortable
        // one.
        double way = gap - StandingDistance;
        double needed =
            way <= 0
                ? Math.Max(2 * Comfortable, speed * speed / (2 * MinDistance))
                : ((speed * speed) - (_leader.Speed * _leader.Speed)) / (2 * Math.Max(MinDistance, way));
        _isBraking = needed > (_isBraking ? Gentle : Comfortable);
        return _isBraking ? new DrivingControls(controls.Steering, 0, Math.Max(controls.Brake, needed / _car.FullBraking)) : controls;
    }
}
