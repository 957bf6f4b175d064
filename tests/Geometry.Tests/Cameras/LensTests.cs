using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Tests.Cameras;

public sealed class LensTests
{
    [Fact]
    public void Distort_pincushion_moves_outward_by_the_polynomial()
    {
        // r = 0.5 at (0.3, 0.4): factor 1 + 0.2 * 0.25 + 0.4 * 0.0625 = 1.075.
        Vector2D shown = new Lens(1, 0, 0, 0.2, 0.4).Distort(new Vector2D(0.3, 0.4));

        Assert.Equal(0.3225, shown.X, 1e-15);
        Assert.Equal(0.43, shown.Y, 1e-15);
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(-0.3, 0)]
    [InlineData(0.3, 0)]
    [InlineData(-0.5, 0.3)]
    [InlineData(0.2, -0.1)]
    [InlineData(-1, 1)]
    public void Undistort_inverts_Distort_far_beyond_any_image(double k1, double k2)
    {
        var lens = new Lens(1, 0, 0, k1, k2);
        double before = 0;
        for (double radius = 0; radius < 20; radius += 0.01)
        {
            double shown = lens.Distort(new Vector2D(radius, 0)).X;
            Assert.True(radius == 0 || shown > before, $"the mapping turns back at r = {radius}");
            before = shown;

            // Where the slope is as small as 0.1 the inverse magnifies rounding tenfold.
            Assert.Equal(radius, lens.Undistort(new Vector2D(shown, 0)).X, 1e-13 * (1 + (20 * radius)));
        }
    }

    [Theory]
    [InlineData(-0.2, 0.05)]
    [InlineData(0.3, 0)]
    [InlineData(0, 1)]
    public void Undistort_inverts_Distort_to_a_degree_beside_the_camera(double k1, double k2)
    {
        var lens = new Lens(1, 0, 0, k1, k2);
        double radius = Math.Tan(89 * Math.PI / 180);

        Assert.Equal(radius, lens.Undistort(lens.Distort(new Vector2D(radius, 0))).X, 1e-12 * radius);
    }

    [Fact]
    public void Lens_invalid_input_is_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new Lens(0, 0, 0, 0, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Lens(1, double.NaN, 0, 0, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Lens(1, 0, 0, double.PositiveInfinity, 0));
    }
}
