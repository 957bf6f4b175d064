using Harvester.Reports.Comparison;
using Harvester.TestSupport;

namespace Harvester.Reports.Tests.Comparison;

public sealed class DistributionDistanceTests
{
    private const double Rounding = 1e-12;

    /// <summary>The sketch keeps the mean of numbers that differ by at most 1/1024.</summary>
    private const double SketchFraction = 1.0 / 1024;

    private const double Turn = 360;

    [Fact]
    public void Values_that_all_move_by_one_have_distance_one() =>
        Assert.Equal(1, DistributionDistance.Wasserstein(Sketch(0, 1, 5), Sketch(1, 2, 6))!.Value, Rounding);

    [Fact]
    public void Distributions_of_different_size_are_compared_by_share()
    {
        // Half of the mass moves from 0 to 2.
        Assert.Equal(1, DistributionDistance.Wasserstein(Sketch(0), Sketch(0, 2, 0, 2))!.Value, Rounding);
    }

    [Fact]
    public void Negative_values_are_in_order() =>
        Assert.Equal(4, DistributionDistance.Wasserstein(Sketch(-3, -1), Sketch(1, 3))!.Value, Rounding);

    [Fact]
    public void Angles_move_the_short_way_round()
    {
        Assert.Equal(20, DistributionDistance.WassersteinOnCircle(Sketch(-170), Sketch(170), Turn)!.Value, Rounding);
        Assert.Equal(180, DistributionDistance.WassersteinOnCircle(Sketch(-90), Sketch(90), Turn)!.Value, Rounding);

        // 170 goes to -175 by 15, and 0 to 5 by 5.
        Assert.Equal(10, DistributionDistance.WassersteinOnCircle(Sketch(170, 0), Sketch(-175, 5), Turn)!.Value, Rounding);
    }

    [Fact]
    public void Empty_distribution_has_no_distance()
    {
        Assert.Null(DistributionDistance.Wasserstein(Sketch(), Sketch(1)));
        Assert.Null(DistributionDistance.WassersteinOnCircle(Sketch(1), Sketch(), Turn));
    }

    [Fact]
    public void Distance_is_the_mean_difference_of_sorted_values() =>
        RandomCases.Check(
            200,
            RandomCases.ArrayOf(RandomCases.Number(-50, 50), 12),
            numbers =>
            {
                double[] first = [.. numbers.Take(6).Order()];
                double[] second = [.. numbers.Skip(6).Order()];
                double expected = first.Zip(second).Average(pair => Math.Abs(pair.First - pair.Second));

                double actual = DistributionDistance.Wasserstein(Sketch(first), Sketch(second))!.Value;

                Assert.Equal(expected, actual, Rounding + (50 * SketchFraction));
            }
        );

    [Fact]
    public void Distance_on_a_circle_is_that_of_the_best_rotation() =>
        RandomCases.Check(
            200,
            RandomCases.ArrayOf(RandomCases.Number(-180, 180), 8),
            numbers =>
            {
                double[] first = [.. numbers.Take(4).Order()];
                double[] second = [.. numbers.Skip(4).Order()];

                // The best assignment of points on a circle keeps their order, so it is one of the rotations.
                double expected = Enumerable
                    .Range(0, 4)
                    .Min(shift =>
                        Enumerable
                            .Range(0, 4)
                            .Average(i =>
                            {
                                double apart = Math.Abs(first[i] - second[(i + shift) % 4]);
                                return Math.Min(apart, Turn - apart);
                            })
                    );

                double actual = DistributionDistance.WassersteinOnCircle(Sketch(first), Sketch(second), Turn)!.Value;

                Assert.Equal(expected, actual, Rounding + (180 * SketchFraction));
            }
        );

    [Fact]
    public void Disjoint_histograms_differ_by_one_and_equal_ones_by_zero()
    {
        double[] even = [0.5, 0.5];

        Assert.Equal((1, 1), (DistributionDistance.TotalVariation([1, 0], [0, 1]), DistributionDistance.JensenShannon([1, 0], [0, 1])));
        Assert.Equal((0, 0), (DistributionDistance.TotalVariation(even, even), DistributionDistance.JensenShannon(even, even)));
    }

    [Fact]
    public void Histograms_that_overlap_by_half_lie_between()
    {
        // The average is (3/4, 1/4), whose entropy is 0.8112781245 bits; less the mean entropy of the two, (1 + 0) / 2.
        Assert.Equal(0.3112781245, DistributionDistance.JensenShannon([0.5, 0.5], [1, 0]), 1e-9);
        Assert.Equal(0.5, DistributionDistance.TotalVariation([0.5, 0.5], [1, 0]), Rounding);
    }

    private static ValueSketch Sketch(params double[] values)
    {
        var sketch = new ValueSketch();
        foreach (double value in values)
        {
            sketch.Add(value);
        }

        return sketch;
    }
}
