namespace Harvester.Geometry;

/// <summary>
/// Latitude, longitude and height on the ellipsoid WGS 84 of places in the world, whose plane z = 0 touches the ellipsoid at the world's
/// origin. The game has no place on Earth: the origin is made up.
/// </summary>
public static class Wgs84
{
    /// <summary>Latitude of the world's origin, degrees north: the city that the game imitates.</summary>
    public const double OriginLatitudeDegrees = 34.05;

    /// <summary>Longitude of the world's origin, degrees east.</summary>
    public const double OriginLongitudeDegrees = -118.25;

    /// <summary>Equatorial radius, metres (NIMA TR8350.2).</summary>
    public const double EquatorialRadius = 6_378_137;

    /// <summary>Flattening (NIMA TR8350.2).</summary>
    public const double Flattening = 1 / 298.257223563;

    private const double SquaredEccentricity = Flattening * (2 - Flattening);

    /// <summary>More steps change nothing near the ground: each reduces the error of the latitude a thousandfold.</summary>
    private const int Steps = 6;

    /// <summary>The geodetic coordinates of a place.</summary>
    /// <param name="world">East, north and up of the world's origin, metres; at most 100 km away.</param>
    /// <returns>Latitude, degrees north; longitude, degrees east; and height above the ellipsoid, metres.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The place is not finite.</exception>
    public static (double LatitudeDegrees, double LongitudeDegrees, double Height) Of(Vector3D world)
    {
        Guard.Finite(world, nameof(world));
        double latitude = Angles.ToRadians(OriginLatitudeDegrees);
        double longitude = Angles.ToRadians(OriginLongitudeDegrees);
        (double sinLat, double cosLat) = (Math.Sin(latitude), Math.Cos(latitude));
        (double sinLon, double cosLon) = (Math.Sin(longitude), Math.Cos(longitude));

        // The point from the centre of the Earth: the origin, where the radius in the prime vertical is N = a / √(1 - e² sin² φ), and
        // from it east, north and up.
        double radius = EquatorialRadius / Math.Sqrt(1 - (SquaredEccentricity * sinLat * sinLat));
        double outward = (world.Z * cosLat) - (world.Y * sinLat) + (radius * cosLat);
        double x = (outward * cosLon) - (world.X * sinLon);
        double y = (outward * sinLon) + (world.X * cosLon);
        double z = (radius * (1 - SquaredEccentricity) * sinLat) + (world.Y * cosLat) + (world.Z * sinLat);

        // Back to the ellipsoid: tan φ = (z + e² N sin φ) / p with p the distance from the axis, iterated from the origin's latitude.
        double fromAxis = Math.Sqrt((x * x) + (y * y));
        double found = latitude;
        double vertical = radius;
        for (int step = 0; step < Steps; step++)
        {
            double sin = Math.Sin(found);
            vertical = EquatorialRadius / Math.Sqrt(1 - (SquaredEccentricity * sin * sin));
            found = Math.Atan2(z + (SquaredEccentricity * vertical * sin), fromAxis);
        }

        double height = (fromAxis / Math.Cos(found)) - vertical;
        return (found * 180 / Math.PI, Math.Atan2(y, x) * 180 / Math.PI, height);
    }
}
