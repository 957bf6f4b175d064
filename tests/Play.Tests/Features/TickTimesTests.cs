using Harvester.Play.Features;

namespace Harvester.Play.Tests.Features;

public sealed class TickTimesTests
{
    /// <summary>The documented error: a class is a fiftieth of a decade wide.</summary>
    private static readonly double ClassWidth = Math.Pow(10, 1.0 / 50);

    [Theory]
    [InlineData(0.5)]
    [InlineData(0.9)]
    [InlineData(0.99)]
    [InlineData(1)]
    public void Percentile_is_at_most_one_bin_too_high(double share)
    {
        var random = new Random(3);
        double[] milliseconds = [.. Enumerable.Range(0, 1000).Select(_ => Math.Pow(10, (5 * random.NextDouble()) - 2))];
        var times = new TickTimes();
        foreach (double time in milliseconds)
        {
            times.Add(time);
        }

        double exact = milliseconds.Order().ElementAt((int)Math.Ceiling(share * milliseconds.Length) - 1);
        Assert.InRange(times.Percentile(share), exact * (1 - 1e-9), exact * ClassWidth * (1 + 1e-9));
        Assert.Equal(1000, times.Count);
    }

    [Fact]
    public void Percentile_of_no_ticks_is_zero() => Assert.Equal(0, new TickTimes().Percentile(0.5));

    [Theory]
    [InlineData(0, 0.001)]
    [InlineData(1e12, 1e5)]
    public void Times_beyond_the_scale_count_in_the_outer_bins(double milliseconds, double expected)
    {
        var times = new TickTimes();
        times.Add(milliseconds);
        Assert.Equal(expected, times.Percentile(0.5), expected * 1e-9);
    }
}
