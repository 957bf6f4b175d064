using Harvester.Datasets.Statistics;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Statistics;

public sealed class QuantileSketchTests
{
    /// <summary>A bin is as wide as 1/4096 of the least number in it.</summary>
    private const double BinFraction = 1.0 / 4096;

    [Theory]
    [InlineData(2_000, 0.3, 150)]
    [InlineData(2_001, 0, 1e-9)]
    [InlineData(1, 40, 50)]
    [InlineData(2, 1, 1e5)]
    public void Median_is_that_of_the_sorted_numbers_to_the_width_of_a_bin(int count, double min, double max)
    {
        RandomCases.Check(
            20,
            RandomCases.ArrayOf(RandomCases.Number(min, max), count),
            numbers =>
            {
                var sketch = new QuantileSketch();
                foreach (double number in numbers)
                {
                    sketch.Add(number);
                }

                double[] sorted = [.. numbers.Order()];
                double median = (sorted[(count - 1) / 2] + sorted[count / 2]) / 2;
                Assert.InRange(sketch.Median, median * (1 - BinFraction), median * (1 + BinFraction));
                Assert.Equal((count, numbers.Min()), (sketch.Count, sketch.Min));
            }
        );
    }

    [Fact]
    public void Bins_do_not_grow_with_the_numbers()
    {
        var sketch = new QuantileSketch();
        for (int i = 0; i < 1_000_000; i++)
        {
            sketch.Add(64 + (i % 640_000 / 10_000.0));
        }

        // From 64 up to 128 numbers double once: 4,096 bins, each 1/64 wide. Each number is there once or twice: those below 100 twice,
        // which are 720,000 of the million, so that the two in the middle of them are at 64 + 249,999/10,000 and 64 + 250,000/10,000, on
        // either side of the border of two bins at 89.
        Assert.Equal(4096, sketch.Bins);
        Assert.InRange(sketch.Median, 89 - (1.0 / 64), 89 + (1.0 / 64));
    }

    [Fact]
    public void Add_of_a_number_below_zero_is_refused() => Assert.Throws<ArgumentOutOfRangeException>(() => new QuantileSketch().Add(-1));
}
