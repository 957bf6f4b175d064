using Harvester.Capture.Harvesting;

namespace Harvester.Capture.Tests.Harvesting;

public sealed class FrameScheduleTests
{
    [Fact]
    public void TakeIfDue_takes_every_sixth_tick_despite_rounding_errors()
    {
        var schedule = new FrameSchedule(10);
        double time = 1000;
        var taken = new List<int>();
        for (int tick = 0; tick < 6_000; tick++, time += 1.0 / 60)
        {
            if (schedule.TakeIfDue(time))
            {
                taken.Add(tick);
            }
        }

        Assert.Equal(Enumerable.Range(0, 1_000).Select(frame => frame * 6), taken);
    }

    [Fact]
    public void TakeIfDue_while_time_stands_still_takes_one_frame()
    {
        var schedule = new FrameSchedule(10);

        Assert.True(schedule.TakeIfDue(5));
        Assert.False(schedule.TakeIfDue(5));
    }

    [Fact]
    public void TakeIfDue_after_a_long_wait_does_not_catch_up()
    {
        var schedule = new FrameSchedule(10);
        schedule.TakeIfDue(0);

        Assert.True(schedule.TakeIfDue(3.05));
        Assert.False(schedule.TakeIfDue(3.06));
        Assert.True(schedule.TakeIfDue(3.1));
    }
}
