using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The errors of a radar at one moment: noise, ghosts of objects, and detections of nothing. The same moment has the same errors; without
/// any, detections are exact.
/// </summary>
internal sealed class RadarErrors(RigRadar radar, long gameFrame)
{
    /// <summary>The nearest clutter, metres.</summary>
    private const double MinClutterMetres = 1;

    /// <summary>Clutter reflects like 0.1 to 1 m², decibels above 1 m².</summary>
    private const double MinClutterSection = -10;

    /// <summary>A ghost is weaker than its object by a further reflection, decibels.</summary>
    private const double GhostLoss = 10;

    private readonly NoiseSource _source = new(NoiseSource.HashOf(radar.Name) ^ (ulong)gameFrame);

    /// <summary>The detection with noise.</summary>
    public RadarDetection Measured(RadarDetection exact) =>
        exact with
        {
            Range = Math.Max(exact.Range + Noise(radar.RangeNoiseMetres), double.Epsilon),
            AzimuthDegrees = exact.AzimuthDegrees + Noise(radar.AzimuthNoiseDegrees),
            RadialVelocity = exact.RadialVelocity + Noise(radar.VelocityNoise),
        };

    /// <summary>
    /// The ghost of a detection; null if it has none. The wave goes to the object, back to the vehicle, and to the object again: twice the
    /// range and twice the radial velocity, in the same direction.
    /// </summary>
    public RadarDetection? GhostOf(RadarDetection target) =>
        radar.GhostFraction > 0 && target.Object != 0 && 2 * target.Range <= radar.RangeMetres && _source.Next() < radar.GhostFraction
            ? target with
            {
                Range = 2 * target.Range,
                RadialVelocity = 2 * target.RadialVelocity,
                CrossSection = target.CrossSection - GhostLoss,
                Origin = RadarOrigin.Ghost,
            }
            : null;

    /// <summary>Detections of nothing: a number of them by Poisson's law, anywhere in the sector, that stand over the ground.</summary>
    /// <param name="standingVelocity">The radial velocity of what stands in a direction of the sensor's frame, m/s.</param>
    public IEnumerable<RadarDetection> Clutter(Func<Vector3D, double> standingVelocity)
    {
        int count = CountOfClutter();
        for (int i = 0; i < count; i++)
        {
            double azimuth = (_source.Next() - 0.5) * radar.AzimuthDegrees;
            double range = MinClutterMetres + (_source.Next() * (radar.RangeMetres - MinClutterMetres));
            double section = MinClutterSection * _source.Next();
            double radians = Angles.ToRadians(azimuth);
            double velocity = standingVelocity(new Vector3D(-Math.Sin(radians), Math.Cos(radians), 0));
            yield return new RadarDetection(range, azimuth, 0, velocity, 0, section, 0, RadarOrigin.Clutter);
        }
    }

    /// <summary>
    /// Knuth's way to draw from Poisson's distribution: uniform numbers are multiplied until they are below e to the -mean.
    /// </summary>
    private int CountOfClutter()
    {
        int count = 0;
        double limit = Math.Exp(-radar.Clutter);
        for (double product = _source.Next(); radar.Clutter > 0 && product > limit; product *= _source.Next())
        {
            count++;
        }

        return count;
    }

    private double Noise(double deviation) => deviation > 0 ? deviation * _source.NextNormal() : 0;
}
