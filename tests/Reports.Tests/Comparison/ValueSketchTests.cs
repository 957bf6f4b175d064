using Harvester.Reports.Comparison;

namespace Harvester.Reports.Tests.Comparison;

public sealed class ValueSketchTests
{
    [Fact]
    public void Quantiles_of_few_values_are_exact()
    {
        ValueSketch sketch = Of(4, 1, 3, 2);

        Assert.Equal((1, 2, 4), (sketch.Quantile(0), sketch.Quantile(0.5), sketch.Quantile(1)));
        Assert.Equal(2.5, sketch.Mean);
    }

    [Fact]
    public void Sketch_without_values_has_no_mean_and_no_median() => Assert.Equal((null, null), (Of().Mean, Of().Quantile(0.5)));

    [Fact]
    public void Memory_does_not_grow_with_the_number_of_values()
    {
        var sketch = new ValueSketch();
        for (int i = 0; i < 1_000_000; i++)
        {
            sketch.Add(1 + (i % 99_991 / 1000.0));
        }

        // From 1 to 101 are fewer than seven doublings of 1,024 bins each.
        Assert.InRange(sketch.Points.Count, 1000, 7 * 1024);
        Assert.Equal(1_000_000, sketch.Count);
    }

    [Fact]
    public void Values_beyond_a_histogram_count_in_its_first_and_last_bin() =>
        Assert.Equal([0.5, 0, 0.5], Of(-1, 0.5, 2, 99).Fractions([0, 1, 2, 3]));

    [Fact]
    public void Value_on_an_edge_counts_in_the_upper_bin() => Assert.Equal([0, 1], Of(1).Fractions([0, 1, 2]));

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void Value_that_is_not_finite_is_refused(double value) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new ValueSketch().Add(value));

    private static ValueSketch Of(params double[] values)
    {
        var sketch = new ValueSketch();
        foreach (double value in values)
        {
            sketch.Add(value);
        }

        return sketch;
    }
}
