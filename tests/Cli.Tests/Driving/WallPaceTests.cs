using Harvester.Runs.Driving;

namespace Harvester.Cli.Tests.Driving;

public sealed class WallPaceTests
{
    private static readonly TimeSpan Tick = TimeSpan.FromSeconds(0.05);
    private readonly Clock _clock = new();

    [Fact]
    public void Ticks_follow_the_clock_however_long_their_work_takes()
    {
        WallPace pace = new(Tick.TotalSeconds, _clock);
        for (int i = 0; i < 10; i++)
        {
            // Work of 0.03 s leaves 0.02 s; the first tick has none before it.
            Assert.Equal(TimeSpan.FromSeconds(i == 0 ? 0.05 : 0.02), Go(pace, isFrozen: false));
            _clock.Now += TimeSpan.FromSeconds(0.03);
        }
    }

    [Fact]
    public void Paused_world_does_not_catch_up_later()
    {
        WallPace pace = new(Tick.TotalSeconds, _clock);
        Go(pace, isFrozen: false);
        for (int i = 0; i < 6000; i++)
        {
            Assert.Equal(TimeSpan.FromMilliseconds(1), Go(pace, isFrozen: true));
        }

        // The first tick after six seconds is overdue; from there on each has its time.
        Assert.Equal(TimeSpan.Zero, Go(pace, isFrozen: false));
        Assert.Equal(Tick, Go(pace, isFrozen: false));
        Assert.Equal(Tick, Go(pace, isFrozen: false));
    }

    [Fact]
    public void Slow_machine_does_not_catch_up_later()
    {
        WallPace pace = new(Tick.TotalSeconds, _clock);
        Go(pace, isFrozen: false);
        _clock.Now += TimeSpan.FromSeconds(3);

        Assert.Equal(TimeSpan.Zero, Go(pace, isFrozen: false));
        Assert.Equal(Tick, Go(pace, isFrozen: false));
    }

    [Fact]
    public void Hurried_ticks_are_due_at_once_without_affecting_later_ones()
    {
        WallPace pace = new(Tick.TotalSeconds, _clock);
        for (int i = 0; i < 100; i++)
        {
            Assert.Equal(TimeSpan.Zero, pace.NextWait(isFrozen: false, isHurried: true));
        }

        Assert.Equal(Tick, Go(pace, isFrozen: false));
    }

    /// <summary>Waits for the given time, on the test's clock.</summary>
    private TimeSpan Go(WallPace pace, bool isFrozen)
    {
        TimeSpan wait = pace.NextWait(isFrozen, isHurried: false);
        _clock.Now += wait;
        return wait;
    }

    private sealed class Clock : TimeProvider
    {
        public TimeSpan Now { get; set; }

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public override long GetTimestamp() => Now.Ticks;
    }
}
