namespace Harvester.Geometry.Tests;

public sealed class AnglesTests
{
    [Theory]
    [InlineData(0, 0)]
    [InlineData(Math.PI, Math.PI)]
    [InlineData(-Math.PI, Math.PI)]
    [InlineData(3 * Math.PI / 2, -Math.PI / 2)]
    [InlineData(-5 * Math.PI / 2, -Math.PI / 2)]
    public void WrapRadians_lands_in_the_half_open_range(double angle, double expected) =>
        Assert.Equal(expected, Angles.WrapRadians(angle), 1e-12);

    [Theory]
    [InlineData(360, 0)]
    [InlineData(-90, 270)]
    [InlineData(725, 5)]
    [InlineData(-1e-300, 0)]
    public void WrapHeadingDegrees_lands_in_0_to_360(double angle, double expected) =>
        Assert.Equal(expected, Angles.WrapHeadingDegrees(angle));

    [Theory]
    [InlineData(0, 1, 0)]
    [InlineData(-1, 0, 90)]
    [InlineData(0, -1, 180)]
    [InlineData(1, 0, 270)]
    public void HeadingDegrees_counts_counter_clockwise_from_north(double x, double y, double expected) =>
        Assert.Equal(expected, Angles.HeadingDegrees(new Vector3D(x, y, 0)), 1e-12);

    [Fact]
    public void HeadingDegrees_inverts_FromHeading()
    {
        for (int heading = 0; heading < 360; heading++)
        {
            double back = Angles.HeadingDegrees(Axes.FromHeading(heading).Forward);
            Assert.Equal(0, Angles.WrapRadians(Angles.ToRadians(back - heading)), 1e-12);
        }
    }

    [Fact]
    public void Wrap_functions_refuse_angles_that_are_not_finite()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => Angles.WrapRadians(double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => Angles.WrapHeadingDegrees(double.NegativeInfinity));
    }
}
