using FsCheck.Fluent;
using Harvester.Geometry.Roads;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.Roads;

public sealed class PathGridTests
{
    [Theory]
    [InlineData(10.3, 10.25, 10.375)]
    [InlineData(-10.3, -10.25, -10.375)]
    [InlineData(0.2, 0, 0)]
    [InlineData(-0.2, 0, 0)]
    public void RemoveBias_after_Truncate_lands_in_the_middle_of_the_step(double x, double stored, double expected)
    {
        Vector3D truncated = PathGrid.Truncate(new Vector3D(x, x, 0));

        Assert.Equal(stored, truncated.X);
        Assert.Equal(expected, PathGrid.RemoveBias(truncated).X);
    }

    [Fact]
    public void RemoveBias_leaves_no_mean_error_and_at_most_half_a_step()
    {
        double sum = 0;
        const int count = 20_000;
        RandomCases.Check(
            count,
            Arb.Zip(RandomCases.Number(-4000, 4000), RandomCases.Number(1, 501)),
            drawn =>
            {
                var place = new Vector3D(drawn.Item1, 1, drawn.Item2);
                Vector3D error = PathGrid.RemoveBias(PathGrid.Truncate(place)) - place;
                Assert.InRange(Math.Abs(error.X), 0, place.X is > -0.25 and < 0.25 ? 0.25 : 0.125);
                Assert.InRange(Math.Abs(error.Z), 0, 1.0 / 64);
                sum += error.X * Math.Sign(place.X);
            }
        );

        // Uniform over ±0.125 m: the mean of 20,000 has a standard deviation of 0.072/141 = 0.0005 m.
        Assert.InRange(sum / count, -0.0025, 0.0025);
    }

    [Theory]
    [InlineData(-3114.5, -9.25, 489)]
    [InlineData(0, 0, 528)]
    [InlineData(-9000, -9000, 0)]
    [InlineData(9000, 9000, 1023)]
    public void CellOf_counts_from_the_south_west(double x, double y, int expected) =>
        Assert.Equal(expected, PathGrid.CellOf(new Vector3D(x, y, 0)));
}
