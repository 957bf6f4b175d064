using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Driving.Recording;

/// <summary>
/// Measures acceleration and turning rate of a car as their means over a tick, from its poses and velocities before and after it.
/// </summary>
internal sealed class InertialSensor
{
    /// <summary>Metres beyond its way at its speed by which only a car that was placed elsewhere is displaced.</summary>
    private const double Displaced = 1;

    private EgoState? _before;
    private double _beforeSeconds;

    /// <summary>Acceleration in the last tick, m/s², along the car's right, forward and up; null if unknown.</summary>
    public Vector3D? Acceleration { get; private set; }

    /// <summary>Turning rate in the last tick, rad/s, about the car's right, forward and up; null if unknown.</summary>
    public Vector3D? AngularRate { get; private set; }

    /// <summary>Takes the state after a tick, or the first one.</summary>
    /// <param name="ego">The car.</param>
    /// <param name="timeSeconds">The game's time, seconds.</param>
    public void Measure(EgoState ego, double timeSeconds)
    {
        double seconds = timeSeconds - _beforeSeconds;
        if (_before is { } before && seconds > 0 && !IsDisplaced(before, ego, seconds))
        {
            Axes axes = ego.Pose.Axes;
            Acceleration = InAxes((ego.Velocity - before.Velocity) * (1 / seconds), axes);
            AngularRate = InAxes(Turn(before.Pose.Axes, axes) * (1 / seconds), axes);
        }
        else
        {
            Acceleration = AngularRate = null;
        }

        _before = ego;
        _beforeSeconds = timeSeconds;
    }

    /// <summary>Discards the last state: the car has been placed elsewhere.</summary>
    public void Reset()
    {
        _before = null;
        Acceleration = AngularRate = null;
    }

    private static bool IsDisplaced(EgoState before, EgoState now, double seconds) =>
        (now.Pose.Position - before.Pose.Position).Length > Displaced + (Math.Max(before.Velocity.Length, now.Velocity.Length) * seconds);

    /// <summary>
    /// The rotation from one orientation to another, world, as axis times angle in radians: half the sum of the cross products of the axes
    /// before and after is the axis times the sine of the angle.
    /// </summary>
    private static Vector3D Turn(Axes before, Axes now)
    {
        Vector3D sine = (before.Right.Cross(now.Right) + before.Forward.Cross(now.Forward) + before.Up.Cross(now.Up)) * 0.5;
        double length = sine.Length;
        return length == 0 ? sine : sine * (Math.Asin(Math.Min(1, length)) / length);
    }

    private static Vector3D InAxes(Vector3D world, Axes axes) => new(world.Dot(axes.Right), world.Dot(axes.Forward), world.Dot(axes.Up));
}
