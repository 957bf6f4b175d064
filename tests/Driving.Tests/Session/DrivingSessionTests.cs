using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Driving.Tests.Doubles;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Session;

/// <summary>What a drive sends, obeys and gives back.</summary>
public sealed class DrivingSessionTests : DrivenGame
{
    [Fact]
    public void Frames_are_sent_at_10_Hz_with_the_state_of_their_pictures()
    {
        using DrivingSession session = Session();
        Run(session, 60);

        Assert.Equal(10, Bridge.Frames.Count);
        Assert.Equal(10, session.Status.Frames);
        Assert.Equal(Enumerable.Range(0, 10).Select(frame => (long)frame), Bridge.Frames.Select(frame => frame.State.Frame));

        // The fake game's pictures hold the number of the state; its time is that number in sixtieths of a second.
        Assert.All(Bridge.Frames, frame => Assert.Equal(FakeGame.StateAt(frame.State.TimeSeconds), frame.Shown));
        Assert.Equal([0L, 6, 12, 18], Bridge.Frames.Take(4).Select(frame => frame.Shown));
        BridgeState third = Bridge.Frames[2].State;
        Assert.Equal(15, third.SpeedMetresPerSecond);
        Assert.Equal(new Vector3D(0, 3, 0), third.Position);
        Assert.Equal(0, third.HeadingDegrees);
        Assert.Equal(LaneIndicators.Unknown, third.Indicators);
    }

    [Fact]
    public void Car_brakes_until_the_client_speaks_and_after_it_falls_silent()
    {
        using DrivingSession session = Session();
        Run(session, 3);
        Assert.All(Car.Driven, controls => Assert.Equal(DrivingControls.Stop, controls));
        Assert.False(session.Status.IsClientAlive);

        Bridge.Say(new ControlsMessage(Left, null));
        Run(session, 60);

        // Heard in tick 3; 30 ticks later half a second has passed, and in the next it is over.
        Assert.Equal(Enumerable.Repeat(Left, 31), Car.Driven.Skip(3).Take(31));
        Assert.Equal(Enumerable.Repeat(DrivingControls.Stop, 29), Car.Driven.Skip(34));
        Assert.False(session.Status.IsClientAlive);
    }

    [Fact]
    public void Indicators_are_turned_into_controls_by_the_game()
    {
        var controller = new NotingController(Left);
        using DrivingSession session = Session(() => controller);
        Bridge.Say(new IndicatorsMessage([0.1, -7, 3.5, 7, 75, 75, -9.5, -1.6, 2.4, 5.5, 75, 30, 40], 0));
        Run(session, 5);

        Assert.Equal(Enumerable.Repeat(Left, 5), Car.Driven);
        DrivingState state = Assert.Single(controller.States);
        Assert.Equal(0.1, state.TorcsEquivalent.Angle.Value);
        Assert.False(state.TorcsEquivalent.ToMarkingLL.IsValid);
        Assert.Equal(15, state.SpeedMetresPerSecond);
        Assert.Equal(0, state.HeadingRadians);

        // No road is known: lanes are assumed to be 5.4 m wide, 1.35 times those of TORCS.
        Assert.Equal(-1.6 * 1.35, state.Indicators.ToMarkingML.Value, 12);
        Assert.Equal(30, state.Indicators.DistMM.Value);
    }

    [Fact]
    public void Indicators_beyond_any_road_are_reported_and_the_brake_holds()
    {
        using DrivingSession session = Session(() => new DeepDrivingController());
        Bridge.Say(new IndicatorsMessage([.. Enumerable.Repeat(1e308, 13)], null));
        Run(session, 2);

        Assert.Equal([DrivingControls.Stop, DrivingControls.Stop], Car.Driven);
        Assert.Contains("not in the range", session.Problem, StringComparison.Ordinal);
        Assert.False(session.Status.IsOver);
    }

    [Fact]
    public void Lanes_of_known_roads_are_sent_as_the_harvest_labels_them()
    {
        // A straight one-way road north, 400 m, two lanes of 5.4 m: its left edge is 5.4 m left of the nodes, and so of the car.
        var network = new RoadNetwork(
            [new RoadNode(0, 0, new Vector3D(0, -200, 0), "", default), new RoadNode(0, 1, new Vector3D(0, 200, 0), "", default)],
            [new RoadLink(0, 1, 2, 0, null, default)]
        );
        using DrivingSession session = Session(ports: Game.Ports with { Roads = new FixedRoads(network, "simulation") });
        Run(session, 1);

        BridgeState state = Assert.Single(Bridge.Frames).State;
        Assert.True(state.IsFast);
        Assert.Equal(0, state.Indicators.Angle.Value, 9);
        Assert.Equal(-5.4, state.Indicators.ToMarkingL.Value, 9);
        Assert.Equal(0, state.Indicators.ToMarkingM.Value, 9);
        Assert.Equal(5.4, state.Indicators.ToMarkingR.Value, 9);
        Assert.Equal(4, state.TorcsEquivalent.ToMarkingR.Value, 9);

        // The other car is 12 m ahead and 2 m to the right.
        Assert.Equal(12, state.Indicators.DistR.Value, 6);
        Assert.Equal(70, state.Indicators.DistL.Value);
    }

    [Fact]
    public void Player_input_ends_the_drive_and_the_world_resumes()
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true), new ControlsMessage(Left, null));
        Run(session, 5);
        Assert.True(Game.WantsFrozen);
        Car.IsTakenByPlayer = true;
        Run(session, 1);
        Car.IsTakenByPlayer = false;
        Bridge.Say(new ControlsMessage(Left, null));
        Run(session, 10);

        Assert.Equal("The player has taken the wheel.", session.Status.Ending);
        Assert.Equal(5, Car.Driven.Count);
        Assert.False(Game.WantsFrozen);
    }

    [Fact]
    public void Reset_moves_the_car_and_starts_a_new_controller()
    {
        int controllers = 0;
        using DrivingSession session = Session(() =>
        {
            controllers++;
            return new NotingController(Left);
        });
        Bridge.Say(new ControlsMessage(Left, null));
        Run(session, 2);
        Bridge.Say(new ResetMessage(new Vector3D(1, 2, 3), 90));
        Run(session, 1);

        Assert.Equal([(new Vector3D(1, 2, 3), 90.0)], Car.Resets);
        Assert.Equal(DrivingControls.Stop, Car.Driven[^1]);
        Assert.Equal(2, controllers);
    }

    [Fact]
    public void Controls_after_a_reset_in_the_same_tick_apply()
    {
        using DrivingSession session = Session();
        Bridge.Say(new ResetMessage(default, 0), new ControlsMessage(Left, null));
        Run(session, 1);

        Assert.Equal([Left], Car.Driven);
    }

    [Fact]
    public void Controls_before_a_reset_in_the_same_tick_are_dropped()
    {
        using DrivingSession session = Session();
        Bridge.Say(new ControlsMessage(Left, null), new ResetMessage(default, 0));
        Run(session, 3);

        Assert.Single(Car.Resets);
        Assert.Equal(Enumerable.Repeat(DrivingControls.Stop, 3), Car.Driven);
    }

    [Fact]
    public void Environment_is_set_and_an_unknown_weather_is_reported()
    {
        using DrivingSession session = Session();
        Bridge.Say(new EnvironmentMessage("rain", new TimeSpan(17, 30, 0)), new EnvironmentMessage("hail", null));
        Run(session, 2);

        Assert.Equal([("rain", new TimeSpan(17, 30, 0))], Car.Environments.Select(set => (set.Weather!, set.TimeOfDay!.Value)));
        Assert.Contains("hail", session.Problem, StringComparison.Ordinal);
        Assert.False(session.Status.IsOver);
    }

    [Fact]
    public void Unusable_picture_is_reported_and_commands_continue()
    {
        Game.GrabAnswer = GrabResult.Refused("covered");
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true), new StepMessage(0.1), new PauseMessage(false));
        Run(session, 60);

        Assert.Empty(Bridge.Frames);
        Assert.Contains("covered", session.Problem, StringComparison.Ordinal);
        Assert.False(Game.WantsFrozen);
        Assert.False(session.Status.IsOver);
        Game.GrabAnswer = GrabResult.Good;
        Run(session, 1);
        Assert.Single(Bridge.Frames);
    }

    [Fact]
    public void Port_fault_ends_the_drive_with_a_message_and_resumes_time()
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true));
        Run(session, 2);
        Car.OnCall = () => throw new InvalidOperationException("The car is gone.");
        Run(session, 2);

        Assert.Equal("The drive stopped: The car is gone.", session.Status.Ending);
        Assert.False(Game.WantsFrozen);
    }

    [Theory]
    [InlineData(nameof(FakeGame.ReadEgo))]
    [InlineData(nameof(FakeGame.Grab))]
    [InlineData(nameof(FakeGame.Unfreeze))]
    public void Port_exceptions_never_reach_the_game_loop(string port)
    {
        using DrivingSession session = Session();
        Game.OnCall = call => Assert.False(call == port, $"{port} fails.");
        Bridge.Say(new PauseMessage(true), new StepMessage(0.1), new IndicatorsMessage(new double[13], null));
        Run(session, 30);
        session.Stop();

        Assert.Contains($"{port} fails.", session.Status.Ending, StringComparison.Ordinal);
    }

    [Fact]
    public void Stop_resumes_a_paused_world_and_touches_no_running_one()
    {
        int unfreezes = 0;
        Game.OnCall = call => unfreezes += call == nameof(FakeGame.Unfreeze) ? 1 : 0;
        using (DrivingSession untouched = Session())
        {
            Run(untouched, 10);
        }

        Assert.Equal(0, unfreezes);
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true));
        Run(session, 10);
        session.Stop();
        session.Stop();

        Assert.Equal(1, unfreezes);
        Assert.False(Game.WantsFrozen);
        Assert.Equal("The drive was stopped.", session.Status.Ending);
    }

    [Fact]
    public void Client_that_floods_the_bridge_does_not_delay_a_tick()
    {
        using var flood = new FloodingBridge();
        using var session = new DrivingSession(
            new DrivingOptions(),
            Game.Ports with
            {
                Car = Car,
            },
            flood,
            () => new NotingController(Left)
        );
        Run(session, 10);

        Assert.Equal(10, Car.Driven.Count);
        Assert.InRange(flood.Taken, 10, 10 * 300);
    }

    [Fact]
    public void Nothing_may_be_drawn_while_a_picture_could_show_it()
    {
        using DrivingSession session = Session();
        var free = new List<int>();
        for (int tick = 0; tick < 13; tick++)
        {
            Run(session, 1);
            if (!session.IsPictureNear)
            {
                free.Add(tick);
            }
        }

        // Pictures are taken in ticks 0, 6 and 12, and are behind by four ticks at most: that of tick 6 may show what tick 2 drew.
        Assert.Equal([0, 1, 6, 7, 12], free);
    }

    [Fact]
    public void Game_without_a_car_to_drive_is_refused() =>
        Assert.Throws<ArgumentException>(() =>
            new DrivingSession(new DrivingOptions(), Game.Ports, Bridge, () => new NotingController(Left))
        );
}
