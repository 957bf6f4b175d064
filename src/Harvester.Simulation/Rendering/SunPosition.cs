using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Where the sun stands, at the latitude of Los Angeles, which the game's city imitates.</summary>
public static class SunPosition
{
    private const double LatitudeDegrees = 34;
    private const double AxialTiltDegrees = 23.44;
    private const int DaysOfYear = 365;

    /// <summary>The spring equinox, 21 March, when the sun stands above the equator.</summary>
    private const int Equinox = 80;

    /// <summary>
    /// The direction of the sun. Its declination is that of Cooper (1969), 23.44 degrees times the sine of the year's angle since the
    /// spring equinox; noon is when it stands in the south.
    /// </summary>
    /// <param name="dayOfYear">1 to 366.</param>
    /// <param name="timeOfDay">Time since midnight.</param>
    /// <returns>Unit vector towards the sun: east, north, up. It points down at night.</returns>
    public static Vector3D DirectionAt(int dayOfYear, TimeSpan timeOfDay)
    {
        double declination = Angles.ToRadians(AxialTiltDegrees) * Math.Sin(2 * Math.PI * (dayOfYear - Equinox) / DaysOfYear);

        // The sun turns by 15° an hour, by 0 at noon. East, north and up of declination δ, hour angle h and latitude φ: -cos δ sin h; sin δ
        // cos φ - cos δ cos h sin φ; sin δ sin φ + cos δ cos h cos φ.
        double hourAngle = (timeOfDay.TotalHours - 12) * Math.PI / 12;
        double latitude = Angles.ToRadians(LatitudeDegrees);
        return new Vector3D(
            -Math.Cos(declination) * Math.Sin(hourAngle),
            (Math.Sin(declination) * Math.Cos(latitude)) - (Math.Cos(declination) * Math.Cos(hourAngle) * Math.Sin(latitude)),
            (Math.Sin(declination) * Math.Sin(latitude)) + (Math.Cos(declination) * Math.Cos(hourAngle) * Math.Cos(latitude))
        );
    }
}
