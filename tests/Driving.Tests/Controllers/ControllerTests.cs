using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Driving.Tests.Doubles;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Driving.Tests.Controllers;

public sealed class ControllerTests
{
    private const double TorcsLock = 0.541052;
    private const double GameLock = 0.6981317;

    [Theory]
    [InlineData(5)]
    [InlineData(10)]
    [InlineData(20)]
    public void DeepDriving_corrects_a_metre_within_eight_seconds(double speed)
    {
        var loop = new ClosedLoop(new DeepDrivingController(), new LaneSection(1, 4), TorcsLock) { Offset = 3, Speed = speed };

        loop.Run(8);

        Assert.Equal(2, loop.Offset, 0.1);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(10)]
    [InlineData(14)]
    public void Stanley_corrects_a_metre_without_leaving_the_lane(double speed)
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

    /// <summary>
    /// Half throttle is 2 m/s² with the engine that the controller assumes and 1 m/s² with that of the loop; the slope takes 1.5.
    /// </summary>
    [Fact]
    public void Stanley_starts_on_a_slope_too_steep_for_half_throttle()
    {
        var loop = new ClosedLoop(new StanleyController(new StanleyOptions()), new LaneSection(1, 5.4), GameLock)
        {
            Speed = 0,
            Slope = 0.15,
        };

        loop.Run(30);

        Assert.True(loop.Speed > 5, $"The car drives at {loop.Speed} m/s.");
    }

    /// <summary>A car that somebody else has held by its brake, as at a light, shows no resistance.</summary>
    [Fact]
    public void Stanley_starts_gently_after_somebody_else_has_braked()
    {
        var controller = new StanleyController(new StanleyOptions());
        LaneIndicators lane = IndicatorCalculator.Compute(0, 2.7, new LaneSection(1, 5.4), []);
        var held = new DrivingState(lane, lane, IsFast: true, 0) { HeadingRadians = 0, PedalsInForce = (0, 1) };
        DrivingControls last = DrivingControls.Stop;
        for (int frame = 0; frame < 150; frame++)
        {
            last = controller.Drive(held);
        }

        // 2 m/s² of the 4 m/s² at full throttle, to the rounding of the filter of the pedal.
        Assert.Equal(0.5, last.Throttle, 1e-6);
    }

    [Fact]
    public void Stanley_moves_to_the_free_lane_when_blocked_and_passes()
    {
        var loop = new ClosedLoop(new StanleyController(new StanleyOptions()), new LaneSection(2, 5.4), GameLock)
        {
            Offset = 8.1,
            Lead = (1, 60, 4),
        };

        loop.Run(
            40,
            at =>
                Assert.True(at.Lead!.Value.Along - at.Along is > 5 or < -5 || at.Offset < 5.4 + 0.5, "The car ran into the vehicle ahead.")
        );

        Assert.True(loop.Along > loop.Lead!.Value.Along);
        Assert.Equal(2.7, loop.Offset, 0.2);
    }

    /// <summary>Its own braking keeps the needed deceleration near the limit at which it begins.</summary>
    [Fact]
    public void Emergency_brake_does_not_swap_with_the_throttle()
    {
        var swaps = new PedalSwaps(new EmergencyBrake(new FullThrottle(), new CarTraits()));
        var loop = new ClosedLoop(swaps, new LaneSection(1, 4), TorcsLock) { Lead = (0, 80, 0) };

        loop.Run(8);

        Assert.Equal(0, swaps.Count);
        Assert.True(loop.Speed < 2, $"It still drives at {loop.Speed} m/s.");
    }

    [Fact]
    public void DeepDriving_moves_to_the_free_lane_when_blocked_and_passes()
    {
        var loop = new ClosedLoop(new DeepDrivingController(), new LaneSection(3, 4), TorcsLock) { Offset = 6, Lead = (1, 120, 8) };

        loop.Run(60);

        Assert.True(loop.Along > loop.Lead!.Value.Along);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void DeepDriving_hits_a_parked_car_that_emergency_brakes_avoid(int lanesBeside)
    {
        // At 10 m/s the published law brakes by a tenth for each m/s too fast, from 15 m on: at 5 m it still has 8 of them
        // (docs/driving.md).
        const double halvesOfTwoCars = 4.8;
        double least = MinGap(new DeepDrivingController());
        Assert.True(least < halvesOfTwoCars, $"It came to a stop {least:0.0} m before.");

        least = MinGap(new EmergencyBrake(new DeepDrivingController(), new CarTraits()));
        Assert.InRange(least, EmergencyBrake.StandingDistance - 2.5, EmergencyBrake.StandingDistance + 1);

        double MinGap(IController controller)
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
    public void DeepDriving_follows_the_optimal_velocity_only_within_15_m(double ahead, double brake)
    {
        // At 14.9 m: 20 · (1 - exp(-2.772 / 20 · 14.9 + 0.693)) = 14.928 m/s; a tenth of what 20.023 m/s is more.
        var section = new LaneSection(1, 4);
        LaneIndicators at = IndicatorCalculator.Compute(0, 2, section, [new VehicleAhead(0, ahead)]);
        DrivingControls controls = new DeepDrivingController().Drive(
            new DrivingState(at, TorcsEquivalent.Of(at, section), IsFast: true, 20.023)
        );

        Assert.Equal(ahead < 15 ? brake : 0.0023, controls.Brake, 0.0003);
    }

    [Fact]
    public void Plan_scales_steering_to_the_steering_lock_of_the_car()
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
    public void Plan_adds_lane_curvature_feedforward_to_the_published_law(bool isHeadingKnown)
    {
        // The road's line bends by 50 m to the left, and the car drives 2 m right of it, along the middle of its lane, at 10 m/s. 10 m
        // ahead the line points 0.2 rad to the left; each frame the car turns by 1/52 rad, and at the car there is no angle. So what it
        // steers is the bend of its lane only: 2.9 / 52 = 0.0558 rad for a car of 2.9 m between the axles. A twentieth less is what it
        // finds, because few places tell no bend (2 m² on 43 of the places' spread); by its own steering it knows its heading less well.
        LaneIndicators at = IndicatorCalculator.Compute(10 / 50.0, 2, new LaneSection(1, 4), []);
        IController controller = new ControllerPlan
        {
            Kind = ControllerKind.DeepDriving,
            Car = new CarTraits { CharacteristicSpeed = 1e6 },
        }.New();
        double steering = 0;
        for (int frame = 0; frame < 60; frame++)
        {
            DrivingState state = new(at, at, IsFast: false, 10) { HeadingRadians = isHeadingKnown ? frame / 52.0 : null };
            steering = controller.Drive(state).Steering;
        }

        Assert.Equal(Math.Atan(2.9 / 52), steering * GameLock, isHeadingKnown ? 0.003 : 0.01);
    }

    [Theory]
    [InlineData(ControllerKind.DeepDriving, 12)]
    [InlineData(ControllerKind.DeepDriving, -12)]
    [InlineData(ControllerKind.Stanley, 12)]
    [InlineData(ControllerKind.Stanley, -12)]
    public void Controllers_keep_their_lane_in_a_hairpin_at_a_low_speed(ControllerKind kind, double radius)
    {
        // The road's line turns by 120 degrees at 12 m of radius; the lane's middle is at 14.7 m to the left, at 9.3 m to the right, where
        // the car needs 17 degrees on its wheels. It has 1.7 m to either side.
        const double halfCar = 1.0;
        var section = new LaneSection(1, 5.4);
        IController controller = new ControllerPlan { Kind = kind, Speed = 4 }.New();
        var loop = new ClosedLoop(controller, section, GameLock)
        {
            Speed = 4,
            LookAhead = 10,
            Bend = (40, 40 + (Math.PI / 1.5 * 12), 1 / radius),
        };

        loop.Run(30, at => Assert.InRange(at.Offset, halfCar, section.LaneWidth - halfCar));

        Assert.True(loop.Along > 80);
    }
}
