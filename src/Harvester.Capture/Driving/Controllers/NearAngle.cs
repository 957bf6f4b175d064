using System;

namespace Harvester.Capture.Driving.Controllers;

/// <summary>
/// Gives a controller that wants the angle near the car that angle, where it is measured further ahead: from the angles seen there before,
/// as <see cref="StanleyController"/> has it.
/// </summary>
internal sealed class NearAngle : IController
{
    private const double PeriodSeconds = 0.1;

    private readonly IController _controller;
    private readonly double _wantedMetres;
    private readonly CarTraits _car;
    private readonly RoadAhead _road;

    /// <summary>Puts the memory before a controller.</summary>
    /// <param name="controller">Who drives.</param>
    /// <param name="measuredMetres">How far ahead the angle is measured.</param>
    /// <param name="wantedMetres">How far ahead the controller wants it.</param>
    /// <param name="car">The car.</param>
    public NearAngle(IController controller, double measuredMetres, double wantedMetres, CarTraits car)
    {
        _controller = controller;
        _wantedMetres = wantedMetres;
        _car = car;
        _road = new RoadAhead(measuredMetres, PeriodSeconds, car);
    }

    public DrivingControls Drive(DrivingState state)
    {
        _ = state ?? throw new ArgumentNullException(nameof(state));
        _road.Observe(state);
        if (state.Indicators.Angle.IsValid)
        {
            var angle = Geometry.Lanes.Indicator.Of(_road.At(_wantedMetres).Angle);
            state = state with
            {
                Indicators = state.Indicators with { Angle = angle },
                TorcsEquivalent = state.TorcsEquivalent with { Angle = angle },
            };
        }

        DrivingControls controls = _controller.Drive(state);
        _road.WantedWheelAngle = controls.Steering * _car.SteeringLockRadians;
        return controls;
    }
}
