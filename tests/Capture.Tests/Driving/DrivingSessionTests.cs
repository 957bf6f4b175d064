using System.Diagnostics.CodeAnalysis;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Bridge;
using Harvester.Capture.Driving.Controllers;
using Harvester.Capture.Imaging;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Capture.Tests.Driving;

/// <summary>A drive in a game of 60 ticks a second, so that a frame at 10 Hz comes every sixth tick and half a second is 30 ticks.</summary>
public sealed class DrivingSessionTests : IDisposable
{
    private static readonly DrivingControls Left = new(0.5, 0.25, 0);
    private readonly FakeGame _game = new();
    private readonly FakeCar _car = new();
    private readonly FakeBridge _bridge = new();

    [Fact]
    public void Frames_go_out_ten_times_a_second_with_the_state_of_their_pictures()
    {
        using DrivingSession session = Session();
        Run(session, 60);

        Assert.Equal(10, _bridge.Frames.Count);
        Assert.Equal(10, session.Status.Frames);
        Assert.Equal(Enumerable.Range(0, 10).Select(frame => (long)frame), _bridge.Frames.Select(frame => frame.State.Frame));

        // The fake game's pictures hold the number of the state; its time is that number in sixtieths of a second.
        Assert.All(_bridge.Frames, frame => Assert.Equal(FakeGame.StateAt(frame.State.TimeSeconds), frame.Shown));
        Assert.Equal([0L, 6, 12, 18], _bridge.Frames.Take(4).Select(frame => frame.Shown));
        BridgeState third = _bridge.Frames[2].State;
        Assert.Equal(15, third.SpeedMetresPerSecond);
        Assert.Equal(new Vector3D(0, 3, 0), third.Position);
        Assert.Equal(0, third.HeadingDegrees);
        Assert.Equal(LaneIndicators.Unknown, third.Indicators);
    }

    [Fact]
    public void Car_brakes_until_the_peer_speaks_and_half_a_second_after_its_last_word()
    {
        using DrivingSession session = Session();
        Run(session, 3);
        Assert.All(_car.Driven, controls => Assert.Equal(DrivingControls.Stop, controls));
        Assert.False(session.Status.IsPeerAlive);

        _bridge.Say(new ControlsMessage(Left, null));
        Run(session, 60);

        // Heard in tick 3; 30 ticks later half a second has passed, and in the next it is over.
        Assert.Equal(Enumerable.Repeat(Left, 31), _car.Driven.Skip(3).Take(31));
        Assert.Equal(Enumerable.Repeat(DrivingControls.Stop, 29), _car.Driven.Skip(34));
        Assert.False(session.Status.IsPeerAlive);
    }

    [Fact]
    public void Indicators_are_driven_by_the_controller_of_this_side()
    {
        var controller = new NotingController(Left);
        using DrivingSession session = Session(() => controller);
        _bridge.Say(new IndicatorsMessage([0.1, -7, 3.5, 7, 75, 75, -9.5, -1.6, 2.4, 5.5, 75, 30, 40], 0));
        Run(session, 5);

        Assert.Equal(Enumerable.Repeat(Left, 5), _car.Driven);
        DrivingState state = Assert.Single(controller.States);
        Assert.Equal(0.1, state.TorcsEquivalent.Angle.Value);
        Assert.False(state.TorcsEquivalent.ToMarkingLL.IsValid);
        Assert.Equal(15, state.SpeedMetresPerSecond);

        // No road is known: lanes are taken to be 5.4 m wide, 1.35 times those of TORCS.
        Assert.Equal(-1.6 * 1.35, state.Indicators.ToMarkingML.Value, 12);
        Assert.Equal(30, state.Indicators.DistMM.Value);
    }

    [Fact]
    public void Indicators_beyond_any_road_are_told_and_the_brake_stays()
    {
        using DrivingSession session = Session(() => new DeepDrivingController());
        _bridge.Say(new IndicatorsMessage([.. Enumerable.Repeat(1e308, 13)], null));
        Run(session, 2);

        Assert.Equal([DrivingControls.Stop, DrivingControls.Stop], _car.Driven);
        Assert.Contains("beyond", session.Problem, StringComparison.Ordinal);
        Assert.False(session.Status.IsOver);
    }

    [Fact]
    public void Lanes_of_known_roads_go_out_as_the_harvest_labels_them()
    {
        // A straight one-way road north, 400 m, two lanes of 5.4 m: its left edge is 5.4 m left of the nodes, and so of the car.
        var network = new RoadNetwork(
            [new RoadNode(0, 0, new Vector3D(0, -200, 0), "", default), new RoadNode(0, 1, new Vector3D(0, 200, 0), "", default)],
            [new RoadLink(0, 1, 2, 0, null, default)]);
        using DrivingSession session = Session(ports: _game.Ports with { Roads = new FixedRoads(network, "simulation") });
        Run(session, 1);

        BridgeState state = Assert.Single(_bridge.Frames).State;
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
    public void Player_at_the_wheel_ends_the_drive_for_good_and_the_world_goes_on()
    {
        using DrivingSession session = Session();
        _bridge.Say(new PauseMessage(true), new ControlsMessage(Left, null));
        Run(session, 5);
        Assert.True(_game.WantsFrozen);
        _car.IsTakenByPlayer = true;
        Run(session, 1);
        _car.IsTakenByPlayer = false;
        _bridge.Say(new ControlsMessage(Left, null));
        Run(session, 10);

        Assert.Equal("The player has taken the wheel.", session.Status.Ending);
        Assert.Equal(5, _car.Driven.Count);
        Assert.False(_game.WantsFrozen);
    }

    [Fact]
    public void Reset_puts_the_car_there_forgets_old_controls_and_starts_a_new_controller()
    {
        int controllers = 0;
        using DrivingSession session = Session(() =>
        {
            controllers++;
            return new NotingController(Left);
        });
        _bridge.Say(new ControlsMessage(Left, null));
        Run(session, 2);
        _bridge.Say(new ResetMessage(new Vector3D(1, 2, 3), 90));
        Run(session, 1);

        Assert.Equal([(new Vector3D(1, 2, 3), 90.0)], _car.Resets);
        Assert.Equal(DrivingControls.Stop, _car.Driven[^1]);
        Assert.Equal(2, controllers);
    }

    [Fact]
    public void Controls_that_come_with_a_reset_count()
    {
        using DrivingSession session = Session();
        _bridge.Say(new ResetMessage(default, 0), new ControlsMessage(Left, null));
        Run(session, 1);

        Assert.Equal([Left], _car.Driven);
    }

    [Fact]
    public void Environment_is_set_and_an_unknown_weather_is_told()
    {
        using DrivingSession session = Session();
        _bridge.Say(new EnvironmentMessage("rain", new TimeSpan(17, 30, 0)), new EnvironmentMessage("hail", null));
        Run(session, 2);

        Assert.Equal([("rain", new TimeSpan(17, 30, 0))], _car.Environments.Select(set => (set.Weather!, set.TimeOfDay!.Value)));
        Assert.Contains("hail", session.Problem, StringComparison.Ordinal);
        Assert.False(session.Status.IsOver);
    }

    [Fact]
    public void Step_lets_the_world_go_on_for_so_long_and_sends_one_frame_of_the_world_that_stands()
    {
        _game.FreezeDelay = 2;
        _game.PictureLag = 3;
        using DrivingSession session = Session();
        _bridge.Say(new PauseMessage(true));
        Run(session, 20);
        long stood = _game.State;
        _bridge.Frames.Clear();

        _bridge.Say(new ControlsMessage(Left, null), new StepMessage(0.5));
        Run(session, 100);

        // 0.5 s are 30 ticks, and the fake game needs 2 more until it stands.
        Assert.Equal(stood + 32, _game.State);
        (BridgeState state, long shown) = Assert.Single(_bridge.Frames);
        Assert.Equal(_game.State, shown);
        Assert.Equal(_game.State, FakeGame.StateAt(state.TimeSeconds));
    }

    [Fact]
    public void Controls_hold_through_steps_however_long_the_peer_thinks_between_them()
    {
        using DrivingSession session = Session();
        _bridge.Say(new PauseMessage(true), new ControlsMessage(Left, null));
        Run(session, 1);
        Run(session, 1_000);
        _bridge.Say(new StepMessage(0.4));
        Run(session, 60);

        Assert.Equal(Enumerable.Repeat(Left, _car.Driven.Count), _car.Driven);
        Assert.Equal(24, _game.State);
    }

    [Fact]
    public void Commands_wait_for_the_frame_of_the_step_before_them()
    {
        using DrivingSession session = Session();
        _bridge.Say(new PauseMessage(true));
        Run(session, 20);
        _bridge.Frames.Clear();
        long stood = _game.State;
        _bridge.Say(new StepMessage(0.1), new StepMessage(0.1), new StepMessage(0.1), new PauseMessage(false));
        Run(session, 3 * (6 + 6));

        Assert.Equal([stood + 6, stood + 12, stood + 18], _bridge.Frames.Take(3).Select(frame => frame.Shown));
        Run(session, 60);
        Assert.False(_game.WantsFrozen);
        Assert.True(_game.State > stood + 18);
    }

    [Fact]
    public void Requested_frame_comes_when_nothing_drawn_before_can_be_in_it()
    {
        using DrivingSession session = Session(options: new DrivingOptions { RateHz = 1 });
        Run(session, 3);
        _bridge.Say(new RequestFrameMessage());
        Run(session, 20);

        // Asked for in tick 3: from then on nothing is drawn, and four ticks later the picture shows none of what was.
        Assert.Equal([0L, 7], _bridge.Frames.Select(frame => frame.Shown));
    }

    [Fact]
    public void Requested_frame_comes_at_once_where_pictures_are_never_behind()
    {
        using DrivingSession session = Session(options: new DrivingOptions { RateHz = 1, SettleTicks = 0 });
        Run(session, 3);
        _bridge.Say(new RequestFrameMessage());
        Run(session, 5);

        Assert.Equal([0L, 3], _bridge.Frames.Select(frame => frame.Shown));
    }

    [Fact]
    public void Requested_frame_of_a_world_that_stands_comes_when_it_stands()
    {
        _game.PictureLag = 3;
        using DrivingSession session = Session();
        Run(session, 1);
        _bridge.Say(new PauseMessage(true), new RequestFrameMessage());
        Run(session, 30);

        Assert.Equal([0L, 1], _bridge.Frames.Select(frame => frame.Shown));
        Assert.Equal(1, FakeGame.StateAt(_bridge.Frames[^1].State.TimeSeconds));
    }

    [Fact]
    public void Picture_that_cannot_be_used_is_told_and_commands_go_on()
    {
        _game.GrabAnswer = GrabResult.Refused("covered");
        using DrivingSession session = Session();
        _bridge.Say(new PauseMessage(true), new StepMessage(0.1), new PauseMessage(false));
        Run(session, 60);

        Assert.Empty(_bridge.Frames);
        Assert.Contains("covered", session.Problem, StringComparison.Ordinal);
        Assert.False(_game.WantsFrozen);
        Assert.False(session.Status.IsOver);
        _game.GrabAnswer = GrabResult.Good;
        Run(session, 1);
        Assert.Single(_bridge.Frames);
    }

    [Fact]
    public void Fault_of_a_port_ends_the_drive_with_a_sentence_and_lets_the_world_go_on()
    {
        using DrivingSession session = Session();
        _bridge.Say(new PauseMessage(true));
        Run(session, 2);
        _car.OnCall = () => throw new InvalidOperationException("The car is gone.");
        Run(session, 2);

        Assert.Equal("The drive stopped: The car is gone.", session.Status.Ending);
        Assert.False(_game.WantsFrozen);
    }

    [Theory]
    [InlineData(nameof(FakeGame.ReadEgo))]
    [InlineData(nameof(FakeGame.Grab))]
    [InlineData(nameof(FakeGame.Unfreeze))]
    public void Ports_that_throw_never_reach_the_games_loop(string port)
    {
        using DrivingSession session = Session();
        _game.OnCall = call => Assert.False(call == port, $"{port} fails.");
        _bridge.Say(new PauseMessage(true), new StepMessage(0.1), new IndicatorsMessage(new double[13], null));
        Run(session, 30);
        session.Stop();

        Assert.Contains($"{port} fails.", session.Status.Ending, StringComparison.Ordinal);
    }

    [Fact]
    public void Stop_gives_back_a_world_that_was_stopped_and_touches_none_that_was_not()
    {
        int unfreezes = 0;
        _game.OnCall = call => unfreezes += call == nameof(FakeGame.Unfreeze) ? 1 : 0;
        using (DrivingSession untouched = Session())
        {
            Run(untouched, 10);
        }

        Assert.Equal(0, unfreezes);
        using DrivingSession session = Session();
        _bridge.Say(new PauseMessage(true));
        Run(session, 10);
        session.Stop();
        session.Stop();

        Assert.Equal(1, unfreezes);
        Assert.False(_game.WantsFrozen);
        Assert.Equal("The drive was stopped.", session.Status.Ending);
    }

    [Fact]
    public void Peer_that_floods_the_bridge_does_not_hold_up_a_tick()
    {
        using var flood = new Flood();
        using var session = new DrivingSession(new DrivingOptions(), _game.Ports with { Car = _car }, flood, () => new NotingController(Left));
        Run(session, 10);

        Assert.Equal(10, _car.Driven.Count);
        Assert.InRange(flood.Taken, 10, 10 * 300);
    }

    [Fact]
    public void Nothing_may_be_drawn_in_the_ticks_whose_display_a_picture_could_show()
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
        Assert.Throws<ArgumentException>(() => new DrivingSession(new DrivingOptions(), _game.Ports, _bridge, () => new NotingController(Left)));

    public void Dispose() => _bridge.Dispose();

    private DrivingSession Session(Func<IController>? controller = null, GamePorts? ports = null, DrivingOptions? options = null) =>
        new(options ?? new DrivingOptions(), (ports ?? _game.Ports) with { Car = _car }, _bridge, controller ?? (() => new NotingController(Left)));

    private void Run(DrivingSession session, int ticks)
    {
        for (int tick = 0; tick < ticks; tick++)
        {
            session.Tick();
            _game.Tick();
        }
    }

    /// <summary>Answers with the same controls always, and notes what it was asked.</summary>
    private sealed class NotingController(DrivingControls answer) : IController
    {
        public List<DrivingState> States { get; } = [];

        public DrivingControls Drive(DrivingState state)
        {
            States.Add(state);
            return answer;
        }
    }

    /// <summary>A bridge whose peer sends faster than anyone can take.</summary>
    private sealed class Flood : IDrivingBridge
    {
        public int Taken { get; private set; }

        public string? Problem => null;

        public void Publish(BridgeState state, PixelBuffer picture)
        {
        }

        public bool TryReceive([NotNullWhen(true)] out PeerMessage? message)
        {
            message = Taken++ % 2 == 0 ? new RequestFrameMessage() : new ControlsMessage(Left, null);
            return true;
        }

        public void Dispose()
        {
        }
    }
}
