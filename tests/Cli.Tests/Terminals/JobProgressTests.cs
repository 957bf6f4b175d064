using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Terminals;

public sealed class JobProgressTests
{
    [Theory]
    // 80 left at 2 a second take 40 s.
    [InlineData(20, 100, 2.0, "20 of 100 frames, 2.0 frames/s, 40 s left")]
    // 90 left at 0.5 a second take 180 s.
    [InlineData(10, 100, 0.5, "10 of 100 frames, 0.5 frames/s, 3 min 0 s left")]
    // 9,000 left at 1 a second take 2 h 30 min.
    [InlineData(1000, 10000, 1.0, "1000 of 10000 frames, 1.0 frames/s, 2 h 30 min left")]
    [InlineData(100, 100, 2.0, "100 of 100 frames, 2.0 frames/s, 0 s left")]
    [InlineData(0, 1_000_000, null, "0 of 1000000 frames")]
    public void Describe_gives_rate_and_time_left_where_the_rate_is_known(int done, int all, double? rate, string expected) =>
        Assert.Equal(expected, JobProgress.Describe(done, all, rate));

    [Fact]
    public void Describe_names_the_unit() => Assert.Equal("300 of 1000 m, 30.0 m/s, 24 s left", JobProgress.Describe(300, 1000, 30, "m"));

    [Fact]
    public void Rate_excludes_the_start_up_and_is_unknown_at_first()
    {
        var rate = new JobRate();

        // A world is built for 60 s, then each frame takes half a second.
        Assert.Null(rate.Report(1, TimeSpan.FromSeconds(60)));
        Assert.Null(rate.Report(2, TimeSpan.FromSeconds(60.5)));
        Assert.Equal(2, rate.Report(3, TimeSpan.FromSeconds(61)));
        Assert.Equal(2, rate.Report(101, TimeSpan.FromSeconds(110)));
    }

    [Fact]
    public void Rate_is_unknown_without_further_progress()
    {
        var rate = new JobRate();

        Assert.Null(rate.Report(0, TimeSpan.Zero));
        Assert.Null(rate.Report(0, TimeSpan.FromMinutes(5)));
    }
}
