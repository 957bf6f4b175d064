using Harvester.Geometry;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Labelling;

/// <summary>The errors of a satellite receiver, sample by sample.</summary>
/// <param name="noise">Its noise.</param>
internal sealed class GnssErrors(GnssNoise noise)
{
    private readonly NoiseSource _source = new(NoiseSource.HashOf("gnss") ^ (ulong)noise.Seed);
    private Vector3D _bias;

    /// <summary>The errors of the next sample: of the position, metres, and of the velocity, m/s, east, north and up.</summary>
    /// <param name="seconds">Time since the sample before, seconds; 0 for the first.</param>
    public (Vector3D Position, Vector3D Velocity) Next(double seconds)
    {
        // The bias is a Wiener process: over an interval dt it changes by K √dt times a normal number.
        double walked = Math.Sqrt(Math.Max(0, seconds));
        _bias += NextNormal(noise.HorizontalWalk * walked, noise.VerticalWalk * walked);
        return (_bias + NextNormal(noise.Horizontal, noise.Vertical), NextNormal(noise.Velocity, noise.Velocity));
    }

    private Vector3D NextNormal(double horizontal, double vertical) =>
        new(_source.NextNormal() * horizontal, _source.NextNormal() * horizontal, _source.NextNormal() * vertical);
}
