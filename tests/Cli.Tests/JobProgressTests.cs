namespace Harvester.Cli.Tests;

public sealed class JobProgressTests
{
    [Theory]
    // 20 frames in 10 s are 2 a second; 80 left take 40 s.
    [InlineData(20, 100, 10, "20 of 100 frames, 2.0 a second, 40 s left")]
    // 10 frames in 20 s are 0.5 a second; 90 left take 180 s.
    [InlineData(10, 100, 20, "10 of 100 frames, 0.5 a second, 3 min 0 s left")]
    [InlineData(100, 100, 50, "100 of 100 frames, 2.0 a second, 0 s left")]
    public void Describe_gives_rate_and_time_left(int done, int all, int seconds, string expected) =>
        Assert.Equal(expected, JobProgress.Describe(done, all, TimeSpan.FromSeconds(seconds)));

    [Fact]
    public void Describe_names_the_unit() =>
        Assert.Equal("300 of 1000 m, 30.0 a second, 24 s left", JobProgress.Describe(300, 1000, TimeSpan.FromSeconds(10), "m"));

    [Fact]
    public void Describe_before_the_first_frame_does_not_divide_by_nothing() =>
        Assert.StartsWith("0 of 1000000 frames, 0.0 a second, ", JobProgress.Describe(0, 1_000_000, TimeSpan.Zero), StringComparison.Ordinal);
}
