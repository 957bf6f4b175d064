using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

public sealed class SilenceWatchTests
{
    private static readonly DrivingControls Left = new(0.5, 0.25, 0);

    [Fact]
    public void Controls_hold_for_half_a_second_before_the_brake()
    {
        var clock = new TestClock();
        var watch = new SilenceWatch(clock);

        Assert.Equal(DrivingControls.Stop, watch.Controls);
        watch.Receive(Left);
        clock.Milliseconds = 500;
        Assert.Equal(Left, watch.Controls);
        clock.Milliseconds = 501;
        Assert.Equal(DrivingControls.Stop, watch.Controls);
        Assert.False(watch.IsClientAlive);
    }

    [Fact]
    public void Reset_brakes_until_the_next_controls()
    {
        var watch = new SilenceWatch(new TestClock());
        watch.Receive(Left);

        watch.Reset();

        Assert.Equal(DrivingControls.Stop, watch.Controls);
        watch.Receive(Left);
        Assert.Equal(Left, watch.Controls);
    }
}
