using Harvester.Driving.Bridge;
using Harvester.Driving.Session;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Session;

/// <summary>When the world of a drive pauses, steps and is shown: lock-step and frames requested by the client.</summary>
public sealed class DrivingSessionPacingTests : DrivenGame
{
    [Fact]
    public void Step_advances_the_world_and_sends_one_frame_of_it()
    {
        Game.FreezeDelay = 2;
        Game.PictureLag = 3;
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true));
        Run(session, 20);
        long stood = Game.State;
        Bridge.Frames.Clear();

        Bridge.Say(new ControlsMessage(Left, null), new StepMessage(0.5));
        Run(session, 100);

        // 0.5 s are 30 ticks, and the fake game needs 2 more until it stands.
        Assert.Equal(stood + 32, Game.State);
        (BridgeState state, long shown) = Assert.Single(Bridge.Frames);
        Assert.Equal(Game.State, shown);
        Assert.Equal(Game.State, FakeGame.StateAt(state.TimeSeconds));
    }

    [Fact]
    public void Frame_of_a_recording_waits_for_the_answer_to_the_last()
    {
        using DrivingSession session = Session(options: new DrivingOptions { WaitsForAnswers = true, SettleTicks = 0 });
        Bridge.IsFrameAwaited = false;
        Run(session, 60);
        Assert.Empty(Bridge.Frames);

        // One is due, and goes at once; the next is due six ticks later.
        Bridge.IsFrameAwaited = true;
        Run(session, 1);
        Assert.Single(Bridge.Frames);
        Run(session, 6);
        Assert.Equal(2, Bridge.Frames.Count);
    }

    [Fact]
    public void Answer_that_comes_during_a_tick_is_taken_before_the_frame()
    {
        using DrivingSession session = Session(options: new DrivingOptions { WaitsForAnswers = true, SettleTicks = 0 });
        Bridge.IsFrameAwaited = false;
        Run(session, 60);
        Bridge.WhenEmpty = () =>
        {
            Bridge.WhenEmpty = static () => { };
            Bridge.Say(new ControlsMessage(Left, null));
            Bridge.IsFrameAwaited = true;
        };
        Run(session, 1);
        Assert.Empty(Bridge.Frames);

        Run(session, 1);
        Assert.Equal(1, session.Answers);
        Assert.Single(Bridge.Frames);
    }

    [Fact]
    public void Nothing_is_hidden_from_the_image_while_no_frame_is_awaited()
    {
        using DrivingSession session = Session(options: new DrivingOptions { WaitsForAnswers = true });
        Bridge.IsFrameAwaited = false;
        Run(session, 60);
        Assert.False(session.IsPictureNear);

        // What was drawn in the tick before is in the image for up to four ticks.
        Bridge.IsFrameAwaited = true;
        Run(session, 4);
        Assert.True(session.IsPictureNear);
        Assert.Empty(Bridge.Frames);
        Run(session, 1);
        Assert.Single(Bridge.Frames);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Paused_world_is_shown_only_after_a_change_appears(bool isReset)
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true));
        Run(session, 20);
        Bridge.Frames.Clear();
        Bridge.Say(isReset ? new ResetMessage(default, 90) : new EnvironmentMessage("rain", null), new RequestFrameMessage());

        // The image lags by up to four ticks.
        Run(session, 4);
        Assert.Empty(Bridge.Frames);
        Run(session, 1);
        Assert.Single(Bridge.Frames);
    }

    [Fact]
    public void Controls_hold_through_steps_however_long_the_client_takes()
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true), new ControlsMessage(Left, null));
        Run(session, 1);
        Run(session, 1_000);
        Bridge.Say(new StepMessage(0.4));
        Run(session, 60);

        Assert.Equal(Enumerable.Repeat(Left, Car.Driven.Count), Car.Driven);
        Assert.Equal(24, Game.State);
    }

    [Fact]
    public void Commands_wait_for_the_frame_of_the_step_before_them()
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true));
        Run(session, 20);
        Bridge.Frames.Clear();
        long stood = Game.State;
        Bridge.Say(new StepMessage(0.1), new StepMessage(0.1), new StepMessage(0.1), new PauseMessage(false));
        Run(session, 3 * (6 + 6));

        Assert.Equal([stood + 6, stood + 12, stood + 18], Bridge.Frames.Take(3).Select(frame => frame.Shown));
        Run(session, 60);
        Assert.False(Game.WantsFrozen);
        Assert.True(Game.State > stood + 18);
    }

    [Fact]
    public void Requested_frame_shows_nothing_drawn_before_the_request()
    {
        using DrivingSession session = Session(options: new DrivingOptions { RateHz = 1 });
        Run(session, 3);
        Bridge.Say(new RequestFrameMessage());
        Run(session, 20);

        // Asked for in tick 3: from then on nothing is drawn, and four ticks later the picture shows none of what was.
        Assert.Equal([0L, 7], Bridge.Frames.Select(frame => frame.Shown));
    }

    [Fact]
    public void Requested_frame_comes_at_once_without_picture_lag()
    {
        using DrivingSession session = Session(options: new DrivingOptions { RateHz = 1, SettleTicks = 0 });
        Run(session, 3);
        Bridge.Say(new RequestFrameMessage());
        Run(session, 5);

        Assert.Equal([0L, 3], Bridge.Frames.Select(frame => frame.Shown));
    }

    [Fact]
    public void Requested_frame_of_a_paused_world_comes_once_it_stands()
    {
        Game.PictureLag = 3;
        using DrivingSession session = Session();
        Run(session, 1);
        Bridge.Say(new PauseMessage(true), new RequestFrameMessage());
        Run(session, 30);

        Assert.Equal([0L, 1], Bridge.Frames.Select(frame => frame.Shown));
        Assert.Equal(1, FakeGame.StateAt(Bridge.Frames[^1].State.TimeSeconds));
    }
}
