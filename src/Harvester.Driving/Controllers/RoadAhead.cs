using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Driving.Controllers;

/// <summary>
/// The angle of the road at the car and the curvature between the car and its look-ahead point, from the angles measured there and from how
/// the car has turned since: by its heading if that is known, otherwise by a bicycle model whose wheels follow the steering.
/// </summary>
/// <param name="lookAheadMetres">Distance ahead at which the angles are measured, metres along the road; 0 or more.</param>
/// <param name="periodSeconds">Time between two frames, seconds.</param>
/// <param name="car">Wheelbase and understeer of the driven car.</param>
/// <param name="place">
/// The car's position beside the road's line, to correct for it in bends; null to assume that the car is on the line.
/// </param>
internal sealed class RoadAhead(double lookAheadMetres, double periodSeconds, CarTraits car, PlaceBesideLine? place = null)
{
    /// <summary>Maximum turn of a car between two frames, radians; beyond it, the car was moved to another place.</summary>
    private const double MaxTurn = 0.5;

    private readonly RoadMemory _memory = new(lookAheadMetres);
    private double? _headingRadians;
    private double _wheelAngle;

    /// <summary>The requested angle of the front wheels, radians, positive to the left.</summary>
    public double RequestedWheelAngle { private get; set; }

    /// <summary>Adds the angle that a frame measures ahead of the car.</summary>
    public void Observe(DrivingState state)
    {
        double metres = state.SpeedMetresPerSecond * periodSeconds;
        double turned =
            state.HeadingRadians is { } now && _headingRadians is { } before
                ? Angles.WrapRadians(now - before)
                : metres * CurvatureOfCar(state.SpeedMetresPerSecond);
        _headingRadians = state.HeadingRadians;
        if (Math.Abs(turned) > MaxTurn)
        {
            _memory.Clear();
        }

        place?.Observe(state.Indicators);
        _memory.Advance(place?.AlongLine(metres, _memory.At(0).Curvature) ?? metres, turned);
        if (state.Indicators.Angle.IsValid)
        {
            _memory.See(state.Indicators.Angle.Value);
        }
        else
        {
            _memory.Clear();
        }
    }

    /// <summary>
    /// The road's heading at a distance ahead minus the car's, radians, and the curvature there, 1/m: that of the car's lane if its
    /// position is known, otherwise the road's.
    /// </summary>
    public (double Angle, double Curvature) At(double metresAhead)
    {
        (double angle, double curvature) = _memory.At(metresAhead);
        return (angle, place?.BendOfLane(curvature) ?? curvature);
    }

    /// <summary>The angle of the front wheels for the bend at a distance ahead at a speed, radians, positive to the left.</summary>
    public double WheelAngleAt(double metresAhead, double speed) =>
        Math.Atan(car.Wheelbase * car.UndersteerAt(speed) * At(metresAhead).Curvature);

    /// <summary>Curvature of the car's path, while the wheels turn towards the requested angle.</summary>
    private double CurvatureOfCar(double speed)
    {
        // The wheels turn towards the requested angle at a limited rate; the curvature is that of their mean angle in the period.
        double most = car.SteeringRate * periodSeconds;
        double before = _wheelAngle;
        double wanted = Math.Max(-car.SteeringLockRadians, Math.Min(car.SteeringLockRadians, RequestedWheelAngle));
        _wheelAngle += Math.Max(-most, Math.Min(most, wanted - _wheelAngle));
        return Math.Tan((before + _wheelAngle) / 2) / (car.Wheelbase * car.UndersteerAt(speed));
    }
}
