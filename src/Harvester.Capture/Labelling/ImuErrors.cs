using Harvester.Geometry;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Labelling;

/// <summary>The errors of an inertial unit, sample by sample.</summary>
/// <param name="noise">Its noise.</param>
internal sealed class ImuErrors(ImuNoise noise)
{
    private readonly NoiseSource _source = new(NoiseSource.HashOf("imu") ^ (ulong)noise.Seed);
    private Vector3D _gyroscopeBias;
    private Vector3D _accelerometerBias;

    /// <summary>The errors of the next sample: of the angular rate, rad/s, and of the specific force, m/s².</summary>
    /// <param name="seconds">Length of the interval over which the sample is the mean, seconds; greater than 0.</param>
    public (Vector3D Rate, Vector3D Force) Next(double seconds)
    {
        // The bias is a Wiener process: over an interval dt it changes by K √dt times a normal number.
        double walked = Math.Sqrt(seconds);
        _gyroscopeBias += NextNormal() * (noise.GyroscopeWalk * walked);
        _accelerometerBias += NextNormal() * (noise.AccelerometerWalk * walked);

        // White noise of the density N, averaged over dt, has the standard deviation N / √dt.
        return (
            _gyroscopeBias + (NextNormal() * (noise.Gyroscope / walked)),
            _accelerometerBias + (NextNormal() * (noise.Accelerometer / walked))
        );
    }

    private Vector3D NextNormal() => new(_source.NextNormal(), _source.NextNormal(), _source.NextNormal());
}
