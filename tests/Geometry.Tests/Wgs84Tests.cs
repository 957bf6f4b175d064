namespace Harvester.Geometry.Tests;

/// <summary>Places on the ellipsoid, turned back into metres by the formula in the other direction.</summary>
public sealed class Wgs84Tests
{
    /// <summary>Rounding of doubles at the radius of the Earth is 1e-9 m, a few hundred times less.</summary>
    private const double ToleranceMetres = 1e-6;

    private const double A = 6_378_137;
    private const double B = 6_356_752.314245179;

    [Fact]
    public void The_origin_is_where_the_documentation_says()
    {
        (double latitude, double longitude, double height) = Wgs84.Of(Vector3D.Zero);

        Assert.Equal(34.05, latitude, 12);
        Assert.Equal(-118.25, longitude, 12);
        Assert.Equal(0, height, 8);
    }

    /// <summary>A plane that touches a sphere of radius R is d² / 2R above it at the distance d: 7.8 m at 10 km.</summary>
    [Fact]
    public void The_plane_leaves_the_ellipsoid() => Assert.InRange(Wgs84.Of(new Vector3D(10_000, 0, 0)).Height, 7.7, 7.9);

    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(1, 2, 3)]
    [InlineData(-4000, 8000, 60)]
    [InlineData(15_000, -13_000, -20)]
    [InlineData(20_000, 0, 3000)]
    public void Metres_come_back(double x, double y, double z)
    {
        (double latitude, double longitude, double height) = Wgs84.Of(new Vector3D(x, y, z));
        double[] place = FromCentre(latitude, longitude, height);
        double[] origin = FromCentre(34.05, -118.25, 0);
        double[] to = [place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]];
        (double phi, double lambda) = (34.05 * Math.PI / 180, -118.25 * Math.PI / 180);

        double east = (-Math.Sin(lambda) * to[0]) + (Math.Cos(lambda) * to[1]);
        double north = (-Math.Sin(phi) * Math.Cos(lambda) * to[0]) - (Math.Sin(phi) * Math.Sin(lambda) * to[1]) + (Math.Cos(phi) * to[2]);
        double up = (Math.Cos(phi) * Math.Cos(lambda) * to[0]) + (Math.Cos(phi) * Math.Sin(lambda) * to[1]) + (Math.Sin(phi) * to[2]);

        Assert.InRange(Math.Abs(east - x), 0, ToleranceMetres);
        Assert.InRange(Math.Abs(north - y), 0, ToleranceMetres);
        Assert.InRange(Math.Abs(up - z), 0, ToleranceMetres);
    }

    /// <summary>
    /// The point from the centre of the Earth, by the half axes: the parametric latitude β has tan β = b/a tan φ, the foot of the point on
    /// the ellipsoid is a cos β, b sin β, and the point is h along the normal.
    /// </summary>
    private static double[] FromCentre(double latitude, double longitude, double height)
    {
        (double phi, double lambda) = (latitude * Math.PI / 180, longitude * Math.PI / 180);
        double beta = Math.Atan(B / A * Math.Tan(phi));
        double outward = (A * Math.Cos(beta)) + (height * Math.Cos(phi));
        return [outward * Math.Cos(lambda), outward * Math.Sin(lambda), (B * Math.Sin(beta)) + (height * Math.Sin(phi))];
    }
}
