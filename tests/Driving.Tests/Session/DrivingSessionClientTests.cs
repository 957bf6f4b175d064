using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Session;

namespace Harvester.Driving.Tests.Session;

/// <summary>What is left of a client that is gone or replaced: nothing.</summary>
public sealed class DrivingSessionClientTests : DrivenGame
{
    [Fact]
    public void Messages_of_a_gone_client_are_dropped_and_the_car_brakes()
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true), new StepMessage(1), new StepMessage(1), new ControlsMessage(Left, null));
        Run(session, 1);
        Bridge.Say(new ResetMessage(default, 90), new PauseMessage(true));
        Run(session, 2);
        Assert.True(session.IsStepping);
        Assert.Equal(Left, Car.Driven[^1]);

        Bridge.ReplaceClient();
        Run(session, 300);

        Assert.Equal(Enumerable.Repeat(DrivingControls.Stop, 300), Car.Driven.Skip(3));
        Assert.Empty(Car.Resets);
        Assert.False(session.IsStepping);
        Assert.False(session.Status.IsClientAlive);
        Assert.Equal(303, Game.State);
    }

    [Fact]
    public void World_stopped_by_a_gone_client_resumes()
    {
        using DrivingSession session = Session();
        Run(session, 1);
        Bridge.Say(new PauseMessage(true));
        Run(session, 10);
        Assert.Equal(1, Game.State);

        Bridge.ReplaceClient();
        Run(session, 6);

        Assert.Equal(7, Game.State);
        Assert.Equal([0L, 6], Bridge.Frames.Select(frame => frame.Shown));
    }

    [Fact]
    public void Next_client_can_stop_the_world_and_only_its_steps_count()
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true), new StepMessage(1), new StepMessage(1), new RequestFrameMessage());
        Run(session, 12);
        Assert.Equal(12, Game.State);

        Bridge.ReplaceClient();
        Bridge.Say(new PauseMessage(true));
        Run(session, 100);
        Assert.Equal(12, Game.State);

        Bridge.Frames.Clear();
        Bridge.Say(new StepMessage(0.1));
        Run(session, 100);
        Assert.Equal(18, Game.State);
        Assert.Single(Bridge.Frames);
    }

    [Fact]
    public void Indicators_of_the_next_client_use_a_new_controller()
    {
        int controllers = 0;
        using DrivingSession session = Session(() =>
        {
            controllers++;
            return new NotingController(Left);
        });
        Run(session, 2);
        Bridge.ReplaceClient();
        Run(session, 2);

        Assert.Equal(2, controllers);
    }
}
