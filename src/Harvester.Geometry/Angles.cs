namespace Harvester.Geometry;

/// <summary>Conversions of angles and headings.</summary>
public static class Angles
{
    private const double RadiansPerDegree = Math.PI / 180;

    /// <summary>Converts degrees to radians.</summary>
    public static double ToRadians(double degrees) => degrees * RadiansPerDegree;

    /// <summary>Converts radians to degrees.</summary>
    public static double ToDegrees(double radians) => radians / RadiansPerDegree;

    /// <summary>The equivalent angle in (-pi, pi], radians.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The angle is not finite.</exception>
    public static double WrapRadians(double radians)
    {
        double wrapped = Math.IEEERemainder(Guard.Finite(radians, nameof(radians)), 2 * Math.PI);
        return wrapped <= -Math.PI ? Math.PI : wrapped;
    }

    /// <summary>The equivalent angle in [0, 360), degrees: the range of the game's headings.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The angle is not finite.</exception>
    public static double WrapHeadingDegrees(double degrees)
    {
        // The remainder has the sign of the dividend. Adding 360 to a tiny negative one rounds to 360, which is 0; adding 0.0 turns -0 into
        // 0.
        double wrapped = Guard.Finite(degrees, nameof(degrees)) % 360;
        wrapped = wrapped < 0 ? wrapped + 360 : wrapped;
        return wrapped >= 360 ? 0 : wrapped + 0.0;
    }

    /// <summary>
    /// The game's heading of a direction in the world: degrees counter-clockwise from north (+y), in [0, 360).
    /// A vertical direction has heading 0.
    /// </summary>
    public static double HeadingDegrees(Vector3D forward) => WrapHeadingDegrees(ToDegrees(Math.Atan2(-forward.X, forward.Y)));
}
