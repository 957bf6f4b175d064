using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Labelling;

/// <summary>The errors of a LiDAR at one moment: noise of the distance and lost points. The same moment has the same errors.</summary>
internal sealed class LidarNoise(RigLidar lidar, long gameFrame)
{
    /// <summary>Noise beyond this number of standard deviations does not bring a surface beyond the range into it.</summary>
    private const double MaxDeviations = 4;

    private readonly NoiseSource _source = new(NoiseSource.HashOf(lidar.Name) ^ (ulong)gameFrame);

    /// <summary>How far beyond its range a LiDAR may meet a surface, metres.</summary>
    public static double ReachOf(RigLidar lidar) => MaxDeviations * lidar.RangeNoiseMetres;

    /// <summary>The measured distance, metres.</summary>
    /// <param name="distance">The true distance, metres.</param>
    public double Measured(double distance)
    {
        if (lidar.RangeNoiseMetres <= 0)
        {
            return distance;
        }

        double radius = Math.Sqrt(-2 * Math.Log(1 - _source.Next()));
        return distance + (lidar.RangeNoiseMetres * radius * Math.Cos(2 * Math.PI * _source.Next()));
    }

    /// <summary>Whether the next point gets lost.</summary>
    public bool IsLost() => lidar.DropOutFraction > 0 && _source.Next() < lidar.DropOutFraction;
}
