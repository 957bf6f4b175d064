using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Measures how the ego moved in the last step of the world.</summary>
internal sealed class MotionMeter(Vehicle ego, EgoCar car)
{
    /// <summary>Metres beyond its way at its speed by which only a car that was placed elsewhere is displaced.</summary>
    private const double Displaced = 1;

    private Pose _before;
    private double _speedBefore;

    /// <summary>The motion in the last step; all 0 before the first and when the ego was placed elsewhere.</summary>
    public EgoMotion Motion { get; private set; } = new(0, 0);

    /// <summary>Speed in its direction, m/s; after an impact it can slide sideways and backwards.</summary>
    private double Speed => ego.Wreck is null ? ego.Speed : ego.Velocity.Dot(ego.Pose.Axes.Forward);

    /// <summary>Begins a step.</summary>
    public void Begin()
    {
        _before = ego.Pose;
        _speedBefore = Speed;
    }

    /// <summary>Ends the step.</summary>
    public void End(double seconds)
    {
        bool wasPlaced =
            (ego.Pose.Position - _before.Position).Length > Displaced + (Math.Max(Math.Abs(_speedBefore), ego.Speed) * seconds);
        Motion = new EgoMotion(
            wasPlaced ? 0 : Horizontal.Turn(_before.Axes.Forward, ego.Pose.Axes.Forward) / seconds,
            wasPlaced ? 0 : (Speed - _speedBefore) / seconds
        )
        {
            Steering = car.Applied?.Steering,
            Throttle = car.Applied?.Throttle,
            Brake = car.Applied?.Brake,
            Manoeuvre = car.Manoeuvre,
        };
    }
}
