using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Session;

namespace Harvester.Driving.Tests.Session;

/// <summary>Which controls a reset voids, and which count after it, where it waits for the end of a step.</summary>
public sealed class DrivingSessionResetTests : DrivenGame
{
    private static readonly DrivingControls Right = new(-0.5, 0.75, 0);

    [Fact]
    public void Controls_after_a_reset_awaiting_a_step_drive_the_next_step()
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true), new ControlsMessage(Left, null), new StepMessage(0.1));
        Run(session, 3);
        Assert.Equal(Left, Car.Driven[^1]);

        // The first step is of six ticks, of which three are over.
        Bridge.Say(new ResetMessage(default, 90), new ControlsMessage(Right, null), new StepMessage(0.1));
        Run(session, 1);
        Assert.Empty(Car.Resets);
        Assert.Equal(Left, Car.Driven[^1]);
        while (Car.Resets.Count == 0)
        {
            Assert.Equal(Left, Car.Driven[^1]);
            Assert.InRange(Car.Driven.Count, 4, 20);
            Run(session, 1);
        }

        Assert.Equal(Right, Car.Driven[^1]);
        int before = Car.Driven.Count;
        Run(session, 6);
        Assert.Equal(Enumerable.Repeat(Right, 6), Car.Driven.Skip(before));
    }

    [Fact]
    public void Controls_before_a_reset_that_awaits_a_step_are_dropped()
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true), new StepMessage(0.1));
        Run(session, 2);
        Bridge.Say(new ControlsMessage(Left, null), new ResetMessage(default, 90), new StepMessage(0.1));
        Run(session, 30);

        Assert.Single(Car.Resets);
        Assert.Equal(Enumerable.Repeat(DrivingControls.Stop, 32), Car.Driven);
    }

    [Fact]
    public void Controls_held_for_a_reset_of_a_gone_client_are_dropped()
    {
        using DrivingSession session = Session();
        Bridge.Say(new PauseMessage(true), new StepMessage(1), new ResetMessage(default, 90), new ControlsMessage(Left, null));
        Run(session, 2);
        Bridge.ReplaceClient();
        Run(session, 100);

        Assert.Empty(Car.Resets);
        Assert.Equal(Enumerable.Repeat(DrivingControls.Stop, 102), Car.Driven);
    }
}
