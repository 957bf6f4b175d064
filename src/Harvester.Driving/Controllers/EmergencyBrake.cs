using System;
using Harvester.Capture.Ports;

namespace Harvester.Driving.Controllers;

/// <summary>
/// Brakes for a controller that does not brake enough: where to come to the speed of the vehicle ahead at a distance of
/// <see cref="StandingDistance"/> takes more than a comfortable braking, v² - v'² over twice the way that is left, it brakes by just that,
/// and nearer than that it lets nobody drive up to a vehicle. It leaves the steering alone, and the pedals too until then. Who comes into
/// sight is taken for standing until he is seen to move.
/// </summary>
public sealed class EmergencyBrake : IController
{
    /// <summary>Way left to the vehicle ahead, centre to centre, metres: room for the halves of a bus and of the car.</summary>
    public const double StandingDistance = 11;

    /// <summary>Braking from which on it acts, m/s².</summary>
    public const double Comfortable = 2;

    private const double PeriodSeconds = 0.1;

    /// <summary>Whatever is left of the way, it is not taken for less, metres.</summary>
    private const double MinDistance = 1;

    private readonly IController _controller;
    private readonly CarTraits _car;
    private readonly LeaderEstimate _leader = new(speedOfNewcomers: 0);

    /// <summary>Puts the brake behind a controller.</summary>
    public EmergencyBrake(IController controller, CarTraits car)
    {
        _controller = controller ?? throw new ArgumentNullException(nameof(controller));
        _car = car ?? throw new ArgumentNullException(nameof(car));
    }

    /// <inheritdoc/>
    public DrivingControls Drive(DrivingState state)
    {
        DrivingControls controls = _controller.Drive(state);
        double speed = state.SpeedMetresPerSecond;
        _leader.Observe(state.Indicators, speed, PeriodSeconds);
        if (_leader.Gap is not { } gap)
        {
            return controls;
        }

        double way = gap - StandingDistance;
        double needed = way <= 0
            ? Math.Max(2 * Comfortable, speed * speed / (2 * MinDistance))
            : ((speed * speed) - (_leader.Speed * _leader.Speed)) / (2 * Math.Max(MinDistance, way));
        return needed > Comfortable
            ? new DrivingControls(controls.Steering, 0, Math.Max(controls.Brake, needed / _car.FullBraking))
            : controls;
    }
}
