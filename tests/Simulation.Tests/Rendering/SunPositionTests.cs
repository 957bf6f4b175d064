using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>
/// The sun at 34 degrees north, in solar time. Noon heights are 56 degrees plus the almanac's declination: 23.44 degrees at the solstices,
/// 0 at the equinox, 15 on the first of May. Hours of sunrise follow from the day's length, with refraction by the air.
/// </summary>
public sealed class SunPositionTests
{
    /// <summary>Cooper's declination is within 0.5 degrees of the true one near the solstices and 1.5 at the equinoxes.</summary>
    private const double DegreesTolerance = 1.5;

    [Theory]
    [InlineData(172, 79.4)]
    [InlineData(355, 32.6)]
    [InlineData(80, 56)]
    [InlineData(121, 71)]
    public void Height_at_noon_is_the_almanacs(int dayOfYear, double degrees)
    {
        Vector3D sun = SunPosition.DirectionAt(dayOfYear, TimeSpan.FromHours(12));

        Assert.InRange(Angles.ToDegrees(Math.Asin(sun.Z)), degrees - DegreesTolerance, degrees + DegreesTolerance);
        Assert.True(sun.Y < 0, "The sun stands in the south at noon.");
        Assert.Equal(1, sun.Length, 12);
    }

    [Theory]
    [InlineData(172, 4.78)]
    [InlineData(355, 7.14)]
    [InlineData(80, 6)]
    public void Sun_rises_in_the_east_at_the_almanacs_hour(int dayOfYear, double hour)
    {
        const double quarter = 0.25;

        Assert.True(SunPosition.DirectionAt(dayOfYear, TimeSpan.FromHours(hour - quarter)).Z < 0);
        Vector3D risen = SunPosition.DirectionAt(dayOfYear, TimeSpan.FromHours(hour + quarter));
        Assert.True(risen is { Z: > 0, X: > 0.5 });
    }
}
