using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.Tests.Driving;

public sealed class CarStateTests
{
    private const double Step = 0.01;

    /// <summary>Of integrating in steps of 10 ms.</summary>
    private const double StepError = 0.02;

    private static readonly CarLimits Limits = new();

    [Fact]
    public void After_without_controls_coasts_straight_and_slows_down()
    {
        CarState car = Run(CarState.At(new Vector2D(3, 4), 0, 10, Limits), new DrivingControls(0, 0, 0), slope: 0, seconds: 1);

        // 0.12 + 0.0004 · 10² = 0.16 m/s² at first, a little less when slower.
        Assert.Equal(9.84, car.Speed, 0.002);
        Assert.Equal(3 + 9.92, car.Origin(Limits).X, 0.002);
        Assert.Equal(4, car.Origin(Limits).Y, 1e-9);
    }

    [Fact]
    public void After_full_braking_stops_in_distance_without_rolling_back()
    {
        CarState car = Run(CarState.At(default, 0, 16, Limits), DrivingControls.Stop, slope: 0, seconds: 4);

        // v² / 2a with a = 8 + 0.12 + 0.0004 v², which is 0.034 on the mean: 256 / 16.31 = 15.70 m.
        Assert.Equal(0, car.Speed);
        Assert.Equal(15.70, car.Origin(Limits).X - 0, 0.05);
    }

    [Fact]
    public void After_downhill_gains_what_gravity_gives()
    {
        CarState car = Run(CarState.At(default, 0, 10, Limits), new DrivingControls(0, 0, 0), slope: -0.1, seconds: 1);

        // g · sin(atan 0.1) = 0.976; less about 0.16 of resistance.
        Assert.Equal(10 + 0.976 - 0.163, car.Speed, 0.005);
    }

    [Fact]
    public void After_at_a_crawl_the_rear_axle_follows_the_bicycle_model()
    {
        var limits = new CarLimits
        {
            Drag = 0,
            RollingResistance = 0,
            SteeringRate = 1000,
            CharacteristicSpeed = 1e9,
        };
        CarState car = CarState.At(default, 0, 2, limits);
        const double wheelAngle = 0.3;

        // Radius 2.9 / tan 0.3 = 9.375 m; half a circle at 2 m/s takes 9.375 · pi / 2 = 14.726 s and ends 18.75 m to the left.
        double radius = 2.9 / Math.Tan(wheelAngle);
        double left = car.RearAxle.Y + (2 * radius);
        car = Run(car, new DrivingControls(wheelAngle / limits.SteeringLockRadians, 0, 0), 0, 14.726, limits);

        Assert.Equal(Math.PI, car.Yaw, 0.005);
        Assert.Equal(left, car.RearAxle.Y, StepError);
        Assert.Equal(-limits.OriginAheadOfRearAxle, car.RearAxle.X, 2 * StepError);
    }

    [Fact]
    public void After_cornering_beyond_tyre_grip_the_car_runs_wide()
    {
        CarState car = Run(CarState.At(default, 0, 25, Limits), new DrivingControls(1, 0, 0), slope: 0, seconds: 1);

        Assert.Equal(Limits.Grip / car.Speed, car.YawRate, 0.01);
    }

    [Fact]
    public void After_full_brake_leaves_little_grip_to_turn()
    {
        CarState car = Run(CarState.At(default, 0, 25, Limits), new DrivingControls(1, 0, 1), slope: 0, seconds: 1);

        // √(8.8² - 8²) = 3.67 m/s² are left.
        Assert.Equal(3.67 / car.Speed, car.YawRate, 0.01);
    }

    [Fact]
    public void After_limits_the_turning_rate_of_the_wheels()
    {
        CarState car = Run(CarState.At(default, 0, 5, Limits), new DrivingControls(-1, 0, 0), slope: 0, seconds: 0.2);

        Assert.Equal(-0.24, car.WheelAngle, 1e-9);
    }

    private static CarState Run(CarState car, DrivingControls controls, double slope, double seconds, CarLimits? limits = null)
    {
        int steps = (int)Math.Round(seconds / Step);
        for (int i = 0; i < steps; i++)
        {
            car = car.After(controls, slope, limits ?? Limits, Step);
        }

        return car;
    }
}
