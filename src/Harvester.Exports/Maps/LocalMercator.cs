using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>
/// Latitude and longitude of metres east and north of an origin at latitude 0 and longitude 0, in the spherical Mercator projection, as
/// Lanelet2's default projector has it.
/// </summary>
internal static class LocalMercator
{
    /// <summary>Radius of the sphere, metres: the equatorial radius of WGS 84.</summary>
    private const double EarthRadius = 6_378_137;

    /// <summary>Latitude, degrees, at metres north of the origin.</summary>
    public static double Latitude(double north) => Degrees((2 * Math.Atan(Math.Exp(north / EarthRadius))) - (Math.PI / 2));

    /// <summary>Longitude, degrees, at metres east of the origin.</summary>
    public static double Longitude(double east) => Degrees(east / EarthRadius);

    /// <summary>Latitude and longitude of a place, degrees.</summary>
    public static (double Latitude, double Longitude) Of(Vector3D place) => (Latitude(place.Y), Longitude(place.X));

    private static double Degrees(double radians) => radians * (180 / Math.PI);
}
