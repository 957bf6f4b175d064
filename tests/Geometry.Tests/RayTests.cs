namespace Harvester.Geometry.Tests;

public sealed class RayTests
{
    [Fact]
    public void Ray_direction_is_scaled_to_unit_length()
    {
        var ray = new Ray(new(1, 0, 0), new(0, 3, 4));

        Assert.Equal(new Vector3D(0, 0.6, 0.8), ray.Direction);
        Assert.Equal(new Vector3D(1, 6, 8), ray.At(10));
    }

    [Fact]
    public void Ray_without_direction_or_finite_origin_is_refused()
    {
        Assert.Throws<InvalidOperationException>(() => new Ray(Vector3D.Zero, Vector3D.Zero));
        Assert.Throws<InvalidOperationException>(() => new Ray(Vector3D.Zero, new(double.NaN, 0, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Ray(new(double.PositiveInfinity, 0, 0), new(1, 0, 0)));
    }

    [Fact]
    public void Cross_of_east_and_north_is_up() => Assert.Equal(new Vector3D(0, 0, 1), new Vector3D(1, 0, 0).Cross(new(0, 1, 0)));
}
