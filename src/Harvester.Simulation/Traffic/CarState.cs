using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// A car on the ground, as a bicycle that does not slide sideways: its rear axle moves in its direction. It is limited by the steering
/// rate, by engine and brakes, and by the grip of the tyres: the front wheels do not turn farther than the grip allows.
/// </summary>
/// <param name="RearAxle">Middle of the rear axle, metres, world x and y.</param>
/// <param name="Yaw">Direction, radians counter-clockwise from east.</param>
/// <param name="Speed">Metres per second, 0 or more; there is no reverse gear.</param>
/// <param name="WheelAngle">Angle of the front wheels, radians, positive to the left.</param>
/// <param name="YawRate">Radians per second, positive to the left.</param>
internal readonly record struct CarState(Vector2D RearAxle, double Yaw, double Speed, double WheelAngle, double YawRate)
{
    public const double Gravity = 9.81;

    /// <summary>Minimum speed by which the grip is divided, m/s; a standing car does not turn in any case.</summary>
    private const double MinSpeed = 0.1;

    /// <summary>Minimum speed by which the power is divided, m/s; below it the throttle limits.</summary>
    private const double MinPoweredSpeed = 1;

    public Vector2D Forward => new(Math.Cos(Yaw), Math.Sin(Yaw));

    /// <summary>A car that drives straight ahead.</summary>
    public static CarState At(Vector2D origin, double yaw, double speed, CarLimits limits)
    {
        CarState state = new(origin, yaw, speed, 0, 0);
        return state with { RearAxle = origin - (state.Forward * limits.OriginAheadOfRearAxle) };
    }

    public Vector2D Origin(CarLimits limits) => RearAxle + (Forward * limits.OriginAheadOfRearAxle);

    /// <summary>Velocity of the origin, which in a turn also moves sideways.</summary>
    public Vector2D Velocity(CarLimits limits) =>
        (Forward * Speed) + (new Vector2D(-Forward.Y, Forward.X) * (YawRate * limits.OriginAheadOfRearAxle));

    /// <summary>The state some time later.</summary>
    /// <param name="controls">Steering and pedals.</param>
    /// <param name="slope">Rise of the road per metre in the car's direction.</param>
    /// <param name="limits">The car's physical limits.</param>
    /// <param name="seconds">Time step, short compared with the car's reactions: at most 0.05.</param>
    public CarState After(DrivingControls controls, double slope, CarLimits limits, double seconds)
    {
        // The wheels turn to the requested angle at a limited rate.
        double turned = Math.Clamp(
            (controls.Steering * limits.SteeringLockRadians) - WheelAngle,
            -limits.SteeringRate * seconds,
            limits.SteeringRate * seconds
        );
        double wheelAngle = WheelAngle + turned;

        // Force per mass by the throttle: constant at low speed, power / speed from there on.
        double pushed = Math.Min(
            controls.Throttle * limits.Acceleration,
            controls.Throttle * limits.PowerPerMass / Math.Max(Speed, MinPoweredSpeed)
        );
        double onTyres = Math.Clamp(pushed - (controls.Brake * limits.Braking), -limits.Grip, limits.Grip);

        // Air c v², rolling resistance, and the slope, g sin(atan(slope)) = g · slope / √(1 + slope²).
        double resisted = (limits.Drag * Speed * Speed) + limits.RollingResistance + (Gravity * slope / Math.Sqrt(1 + (slope * slope)));
        double speed = Math.Max(0, Speed + ((onTyres - resisted) * seconds));
        double mean = (Speed + speed) / 2;

        // Bicycle model with understeer: yaw rate = v tan(δ) / (L (1 + (v / v_ch)²)).
        double ratio = mean / limits.CharacteristicSpeed;
        double asked = mean * Math.Tan(wheelAngle) / (limits.Wheelbase * (1 + (ratio * ratio)));

        // Friction circle: a_along² + a_across² ≤ grip², and a_across = v · yaw rate.
        double sideways = Math.Sqrt((limits.Grip * limits.Grip) - (onTyres * onTyres));
        double most = sideways / Math.Max(mean, MinSpeed);
        double yawRate = Math.Clamp(asked, -most, most);

        // Midpoint rule: the car moves in the direction of the middle of the step.
        double middle = Yaw + (yawRate * seconds / 2);
        Vector2D moved = new Vector2D(Math.Cos(middle), Math.Sin(middle)) * (mean * seconds);
        return new CarState(RearAxle + moved, Yaw + (yawRate * seconds), speed, wheelAngle, yawRate);
    }
}
