using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Tests.Labelling;

/// <summary>The errors of a radar have the size that its description asks for.</summary>
public sealed class RadarErrorsTests
{
    private const int Moments = 4000;

    /// <summary>Four times the spread of a standard deviation, or of a mean in standard deviations, over the moments: 1 / √4000.</summary>
    private const double Spread = 4 / 63.2;

    private static readonly RigRadar Radar = new("ahead", new Pose(Vector3D.Zero, Axes.Identity), 100, 20, 200);

    private static readonly RadarDetection Target = new(50, 10, 0, -5, 3, 12, 7, RadarOrigin.Target);

    [Fact]
    public void Without_errors_a_detection_stays_as_it_is()
    {
        var errors = new RadarErrors(Radar, 1);

        Assert.Equal(Target, errors.Measured(Target));
        Assert.Null(errors.GhostOf(Target));
        Assert.Empty(errors.Clutter(_ => 0));
    }

    [Fact]
    public void Noise_has_its_standard_deviations()
    {
        RigRadar noisy = Radar with { RangeNoiseMetres = 0.4, AzimuthNoiseDegrees = 0.3, VelocityNoise = 0.1 };
        RadarDetection[] measured = [.. Enumerable.Range(0, Moments).Select(moment => new RadarErrors(noisy, moment).Measured(Target))];

        AssertNormal(measured.Select(each => (each.Range - 50) / 0.4));
        AssertNormal(measured.Select(each => (each.AzimuthDegrees - 10) / 0.3));
        AssertNormal(measured.Select(each => (each.RadialVelocity + 5) / 0.1));
    }

    [Fact]
    public void Ghosts_are_as_frequent_as_asked_for_and_in_range()
    {
        RigRadar haunted = Radar with { GhostFraction = 0.25 };
        int ghosts = Enumerable.Range(0, Moments).Count(moment => new RadarErrors(haunted, moment).GhostOf(Target) is not null);

        // The spread of a fraction p over n is √(p (1 - p) / n).
        Assert.InRange(ghosts / (double)Moments, 0.25 - (Spread * 0.433), 0.25 + (Spread * 0.433));
        Assert.Null(new RadarErrors(haunted with { GhostFraction = 1 }, 1).GhostOf(Target with { Range = 101 }));
        Assert.Null(new RadarErrors(haunted with { GhostFraction = 1 }, 1).GhostOf(Target with { Object = 0 }));
    }

    [Fact]
    public void Clutter_has_its_mean_number_and_lies_in_the_sector()
    {
        RigRadar cluttered = Radar with { Clutter = 4 };
        RadarDetection[][] moments =
        [
            .. Enumerable.Range(0, Moments).Select(moment => new RadarErrors(cluttered, moment).Clutter(line => -10 * line.Y).ToArray()),
        ];

        // By Poisson's law, mean and variance of the number are the same.
        Assert.InRange(moments.Average(each => each.Length), 4 - (2 * Spread), 4 + (2 * Spread));
        Assert.InRange(moments.Average(each => Math.Pow(each.Length - 4, 2)), 4 * (1 - (2 * Spread)), 4 * (1 + (2 * Spread)));
        Assert.All(
            moments.SelectMany(each => each),
            each =>
            {
                Assert.InRange(each.AzimuthDegrees, -50, 50);
                Assert.InRange(each.Range, 1, 200);
                Assert.Equal(-10 * Math.Cos(each.AzimuthDegrees * Math.PI / 180), each.RadialVelocity, 1e-9);
            }
        );
    }

    private static void AssertNormal(IEnumerable<double> values)
    {
        double[] all = [.. values];
        double mean = all.Average();
        Assert.InRange(mean, -Spread, Spread);
        Assert.InRange(Math.Sqrt(all.Average(value => (value - mean) * (value - mean))), 1 - Spread, 1 + Spread);
    }
}
