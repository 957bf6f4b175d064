using Harvester.Capture.Harvesting;

namespace Harvester.Capture.Tests.Harvesting;

public sealed class DrivingPaceTests
{
    [Fact]
    public void Pace_is_real_time_over_game_time_since_the_start()
    {
        var pace = new DrivingPace();
        pace.Observe(1_000, 50);
        pace.Observe(4_000, 50.9);
        Assert.Null(pace.RealSecondsPerGameSecond);

        // 12 s of real time for 2 s of the game's.
        pace.Observe(13_000, 52);
        Assert.Equal(6, pace.RealSecondsPerGameSecond);
    }
}
