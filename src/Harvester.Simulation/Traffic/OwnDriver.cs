using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// The built-in driver of the ego, for ticks without controls: steers by the pure pursuit of Coulter (1992) towards a point of its route,
/// and accelerates like all traffic.
/// </summary>
internal static class OwnDriver
{
    /// <summary>The point aimed at is ahead by this, metres, and by the way of this time, seconds.</summary>
    private const double MinAimDistance = 3;
    private const double AimSeconds = 0.5;

    /// <param name="ego">The car on its route.</param>
    /// <param name="car">Its physical state.</param>
    /// <param name="acceleration">The wanted acceleration, m/s².</param>
    /// <param name="rightOffset">Where it shall be, metres to the right of its route.</param>
    /// <param name="limits">Its physical limits.</param>
    public static DrivingControls Controls(Vehicle ego, CarState car, double acceleration, double rightOffset, CarLimits limits)
    {
        double aim = MinAimDistance + (AimSeconds * car.Speed);
        (LanePath path, double distance) = ego.PlaceAhead(aim);
        Vector3D target = path.Line.PositionAt(distance) + (Horizontal.RightOf(path.Line.TangentAt(distance)) * rightOffset);
        Vector2D toTarget = new Vector2D(target.X, target.Y) - car.RearAxle;
        double sideways = car.Forward.Cross(toTarget);
        double ratio = car.Speed / limits.CharacteristicSpeed;

        // The circle through the rear axle, along the heading, and the target: curvature = 2 · left / distance². Wheels turn farther by the
        // understeer of CarState.
        double curvature = 2 * sideways / Math.Max(toTarget.Dot(toTarget), 1);
        double wheelAngle = Math.Atan(curvature * limits.Wheelbase * (1 + (ratio * ratio)));

        // The pedals also make up for air, rolling and slope, as CarState takes them off.
        double uphill = CarState.Gravity * ego.Pose.Axes.Forward.Z;
        double asked = acceleration + (limits.Drag * car.Speed * car.Speed) + limits.RollingResistance + uphill;
        return new DrivingControls(
            wheelAngle / limits.SteeringLockRadians,
            Math.Max(0, asked / limits.Acceleration),
            Math.Max(0, -asked / limits.Braking)
        );
    }
}
