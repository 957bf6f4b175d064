using Harvester.Driving.Bridge;
using Harvester.Driving.Session;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Session;

/// <summary>A drive in a world that moves only by the client's steps.</summary>
public sealed class DrivingSessionLockStepTests : DrivenGame
{
    private static readonly DrivingOptions InLockStep = new() { IsLockStep = true, SettleTicks = 0 };

    [Fact]
    public void World_stands_from_the_beginning_and_sends_nothing()
    {
        using DrivingSession session = Session(options: InLockStep);
        Run(session, 30);

        Assert.True(Game.WantsFrozen);
        Assert.Empty(Bridge.Frames);
    }

    [Fact]
    public void Car_gets_controls_only_while_the_world_moves()
    {
        using DrivingSession session = Session(options: InLockStep);
        Bridge.Say(new ControlsMessage(Left, null));
        Run(session, 5);
        Assert.Empty(Car.Driven);

        Bridge.Say(new StepMessage(0.1));
        Run(session, 30);

        // 0.1 s are six ticks of the fake game.
        Assert.Equal(Enumerable.Repeat(Left, 6), Car.Driven);
    }

    [Fact]
    public void Pause_that_ends_does_not_let_the_world_go()
    {
        using DrivingSession session = Session(options: InLockStep);
        Bridge.Say(new PauseMessage(true), new PauseMessage(false));
        Run(session, 5);
        Assert.True(Game.WantsFrozen);

        Bridge.ReplaceClient();
        Run(session, 5);
        Assert.True(Game.WantsFrozen);
    }

    [Fact]
    public void Restart_leaves_later_messages_to_the_next_drive()
    {
        using DrivingSession session = Session(options: InLockStep);
        Bridge.Say(new RequestFrameMessage(), new RestartMessage(7), new StepMessage(0.1));
        Run(session, 5);

        Assert.Equal(new RestartMessage(7), session.Restart);
        Assert.Single(Bridge.Frames);
        Assert.True(Bridge.TryReceive(out ClientMessage? left));
        Assert.Equal(new StepMessage(0.1), left);
    }

    [Fact]
    public void Restart_is_a_problem_in_real_time()
    {
        using DrivingSession session = Session();
        Bridge.Say(new RestartMessage(7));
        Run(session, 5);

        Assert.Null(session.Restart);
        Assert.Contains("cannot be restarted", session.Problem);

        Bridge.Say(new ControlsMessage(Left, null));
        Run(session, 5);
        Assert.Equal(Left, Car.Driven[^1]);
    }

    [Fact]
    public void Client_that_goes_takes_its_step_and_restart_with_it()
    {
        using DrivingSession session = Session(options: InLockStep);
        Bridge.Say(new StepMessage(10), new RestartMessage(7));
        Run(session, 5);
        long begun = Game.State;

        Bridge.ReplaceClient();
        Bridge.Say(new RequestFrameMessage());
        Run(session, 5);

        Assert.Null(session.Restart);
        (BridgeState state, _) = Assert.Single(Bridge.Frames);
        Assert.Equal(begun, FakeGame.StateAt(state.TimeSeconds));
    }

    [Fact]
    public void Frame_of_a_client_that_has_gone_is_not_counted()
    {
        using DrivingSession session = Session(options: InLockStep);
        Bridge.Say(new RequestFrameMessage());
        Bridge.IsReplacedBeforeNextFrame = true;
        Run(session, 1);

        Assert.Empty(Bridge.Frames);
        Assert.Equal(0, session.Status.Frames);
    }

    [Fact]
    public void Frame_without_an_image_is_published_as_such()
    {
        using DrivingSession session = Session(options: InLockStep);
        Bridge.Say(new StepMessage(0.1, HasPicture: false));
        Run(session, 30);
        Bridge.Say(new StepMessage(0.1));
        Run(session, 30);

        Assert.Equal([false, true], Bridge.Frames.Select(frame => frame.State.HasPicture));
    }
}
