using System;
using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Driving.Controllers;

/// <summary>
/// The angle of the road at the car and the bends between it and its look-ahead point, from the angles seen there and from how the car has
/// turned since: by its heading where that is known, else as a bicycle turns whose wheels follow the steering.
/// </summary>
/// <param name="lookAheadMetres">How far ahead the angles are measured, metres along the road; 0 or more.</param>
/// <param name="periodSeconds">Time between two frames, seconds.</param>
/// <param name="car">Wheelbase and understeer of the driven car.</param>
/// <param name="place">
/// Told where the car is beside the road's line, to make up for it in bends; null to take the car for on the line.
/// </param>
internal sealed class RoadAhead(double lookAheadMetres, double periodSeconds, CarTraits car, PlaceBesideLine? place = null)
{
    /// <summary>No car turns by more between two frames, radians; it was put elsewhere.</summary>
    private const double MaxTurn = 0.5;

    private readonly RoadMemory _memory = new(lookAheadMetres);
    private double? _headingRadians;
    private double _wheelAngle;

    /// <summary>The angle of the front wheels that was last asked for, radians, positive to the left.</summary>
    public double WantedWheelAngle { private get; set; }

    /// <summary>Adds the angle that a frame measures ahead of the car.</summary>
    public void Observe(DrivingState state)
    {
        double metres = state.SpeedMetresPerSecond * periodSeconds;
        double turned = state.HeadingRadians is { } now && _headingRadians is { } before
            ? Angles.WrapRadians(now - before)
            : metres * CurvatureOfCar(state.SpeedMetresPerSecond);
        _headingRadians = state.HeadingRadians;
        if (Math.Abs(turned) > MaxTurn)
        {
            _memory.Forget();
        }

        place?.Observe(state.Indicators);
        _memory.Advance(place?.AlongLine(metres, _memory.At(0).Curvature) ?? metres, turned);
        if (state.Indicators.Angle.IsValid)
        {
            _memory.See(state.Indicators.Angle.Value);
        }
        else
        {
            _memory.Forget();
        }
    }

    /// <summary>
    /// The road's heading some way ahead less the car's, radians, and how it bends there, or the car's lane where its place is known, 1/m.
    /// </summary>
    public (double Angle, double Curvature) At(double metresAhead)
    {
        (double angle, double curvature) = _memory.At(metresAhead);
        return (angle, place?.BendOfLane(curvature) ?? curvature);
    }

    /// <summary>The angle of the front wheels for the bend some way ahead at a speed, radians, positive to the left.</summary>
    public double WheelAngleAt(double metresAhead, double speed) =>
        Math.Atan(car.Wheelbase * car.UndersteerAt(speed) * At(metresAhead).Curvature);

    /// <summary>How the car turns by metre, with the wheels on their way to where they are wanted.</summary>
    private double CurvatureOfCar(double speed)
    {
        double most = car.SteeringRate * periodSeconds;
        double before = _wheelAngle;
        double wanted = Math.Max(-car.SteeringLockRadians, Math.Min(car.SteeringLockRadians, WantedWheelAngle));
        _wheelAngle += Math.Max(-most, Math.Min(most, wanted - _wheelAngle));
        return Math.Tan((before + _wheelAngle) / 2) / (car.Wheelbase * car.UndersteerAt(speed));
    }
}
