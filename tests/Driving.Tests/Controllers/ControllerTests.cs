using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Controllers;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Tests.Controllers;

public sealed class ControllerTests
{
    private const double TorcsLock = 0.541052;
    private const double GameLock = 0.6981317;

    [Theory]
    [InlineData(5)]
    [InlineData(10)]
    [InlineData(20)]
    public void DeepDriving_takes_back_a_metre_within_eight_seconds(double speed)
    {
        var loop = new ClosedLoop(new DeepDrivingController(), new LaneSection(1, 4), TorcsLock) { Offset = 3, Speed = speed };

        loop.Run(8);

        Assert.Equal(2, loop.Offset, 0.1);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(10)]
    [InlineData(14)]
    public void Stanley_takes_back_a_metre_without_leaving_the_lane(double speed)
    {
        var section = new LaneSection(2, 5.4);
        var loop = new ClosedLoop(new StanleyController(new StanleyOptions()), section, GameLock) { Offset = 3.7, Speed = speed };

        loop.Run(8, at => Assert.InRange(at.Offset, 0, 5.4));

        Assert.Equal(2.7, loop.Offset, 0.1);
    }

    [Fact]
    public void Stanley_stops_behind_a_standing_vehicle_in_the_only_lane()
    {
        var loop = new ClosedLoop(new StanleyController(new StanleyOptions()), new LaneSection(1, 5.4), GameLock) { Lead = (0, 60, 0) };

        loop.Run(30, at => Assert.True(at.Lead!.Value.Along - at.Along > 5, "The car ran into the vehicle ahead."));

        Assert.True(loop.Speed < 0.5);
    }

    [Fact]
    public void Stanley_moves_to_the_free_lane_when_blocked_and_passes()
    {
        var loop = new ClosedLoop(new StanleyController(new StanleyOptions()), new LaneSection(2, 5.4), GameLock)
        {
            Offset = 8.1,
            Lead = (1, 60, 4),
        };

        loop.Run(40, at => Assert.True(
            at.Lead!.Value.Along - at.Along is > 5 or < -5 || at.Offset < 5.4 + 0.5, "The car ran into the vehicle ahead."));

        Assert.True(loop.Along > loop.Lead!.Value.Along);
        Assert.Equal(2.7, loop.Offset, 0.2);
    }

    [Fact]
    public void DeepDriving_moves_to_the_free_lane_when_blocked_and_passes()
    {
        var loop = new ClosedLoop(new DeepDrivingController(), new LaneSection(3, 4), TorcsLock)
        {
            Offset = 6,
            Lead = (1, 120, 8),
        };

        loop.Run(60);

        Assert.True(loop.Along > loop.Lead!.Value.Along);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void DeepDriving_runs_into_a_standing_vehicle_where_the_emergency_brake_stops(int lanesBeside)
    {
        // At 10 m/s the published law brakes by a tenth for each m/s too fast, from 15 m on: at 5 m it still has 8 of them (docs/driving.md).
        const double halvesOfTwoCars = 4.8;
        double least = LeastGap(new DeepDrivingController());
        Assert.True(least < halvesOfTwoCars, $"It came to a stop {least:0.0} m before.");

        least = LeastGap(new EmergencyBrake(new DeepDrivingController(), new CarTraits()));
        Assert.InRange(least, EmergencyBrake.StandingDistance - 2.5, EmergencyBrake.StandingDistance + 1);

        double LeastGap(IController controller)
        {
            // A lane beside does not help: half of the time that it takes to be taken for free is over when it is too late.
            var loop = new ClosedLoop(controller, new LaneSection(1 + lanesBeside, 4), TorcsLock)
            {
                Lead = (lanesBeside, 45, 0),
                Offset = 2 + (4 * lanesBeside),
            };
            double gap = double.PositiveInfinity;
            loop.Run(20, at => gap = Math.Min(gap, at.Lead!.Value.Along - at.Along));
            return gap;
        }
    }

    [Theory]
    [InlineData(14.9, 0.5095)]
    [InlineData(15.1, 0)]
    public void DeepDriving_follows_the_optimal_velocity_within_fifteen_metres_only(double ahead, double brake)
    {
        // At 14.9 m: 20 · (1 - exp(-2.772 / 20 · 14.9 + 0.693)) = 14.928 m/s; a tenth of what 20.023 m/s is more.
        var section = new LaneSection(1, 4);
        LaneIndicators at = IndicatorCalculator.Compute(0, 2, section, [new VehicleAhead(0, ahead)]);
        DrivingControls controls = new DeepDrivingController().Drive(new DrivingState(at, TorcsEquivalent.Of(at, section), IsFast: true, 20.023));

        Assert.Equal(ahead < 15 ? brake : 0.0023, controls.Brake, 0.0003);
    }

    [Fact]
    public void Plan_makes_the_published_law_steer_a_car_of_another_lock_by_the_same_angle()
    {
        // Half a metre right of the middle: 0.5 / 8 / 1.5 of a radian is to be steered to the left, whatever the lock.
        const double wheelAngle = 0.5 / 8 / 1.5;
        LaneIndicators at = IndicatorCalculator.Compute(0, 2.5, new LaneSection(1, 4), []);
        DrivingState state = new(at, at, IsFast: true, 10);
        ControllerPlan plan = new() { Kind = ControllerKind.DeepDriving };

        Assert.Equal(wheelAngle / GameLock, plan.New().Drive(state).Steering, 9);
        Assert.Equal(wheelAngle / 0.5, (plan with { Car = new CarTraits { SteeringLockRadians = 0.5 } }).New().Drive(state).Steering, 9);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Plan_gives_the_published_law_the_angle_near_the_car_in_a_bend(bool isHeadingKnown)
    {
        // A bend of 50 m to the left, along its middle at 10 m/s: 10 m ahead it points 0.2 rad to the left, 4.35 m ahead 0.087 rad, for
        // which the law turns the wheels by 0.087 / 1.5 = 0.058 rad: a car of 2.9 m between the axles drives that bend so.
        const double bend = 1.0 / 50;
        LaneIndicators at = IndicatorCalculator.Compute(10 * bend, 2, new LaneSection(1, 4), []);
        IController controller = new ControllerPlan { Kind = ControllerKind.DeepDriving, Car = new CarTraits { CharacteristicSpeed = 1e6 } }.New();
        double steering = 0;
        for (int frame = 0; frame < 40; frame++)
        {
            DrivingState state = new(at, at, IsFast: false, 10) { HeadingRadians = isHeadingKnown ? frame * bend : null };
            steering = controller.Drive(state).Steering;
        }

        Assert.Equal(0.058 * ReshapedAt(0.058 / TorcsLock), steering * GameLock, isHeadingKnown ? 0.002 : 0.02);

        // To the left the published law steers more where it steers much.
        static double ReshapedAt(double steering) => steering > 0.1 ? (2.5 * steering) + 0.75 : 1;
    }
}
