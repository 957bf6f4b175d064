using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Labelling;

/// <summary>The errors of a LiDAR at one moment: noise of the distance and lost points. The same moment has the same errors.</summary>
internal sealed class LidarNoise(RigLidar lidar, long gameFrame)
{
    /// <summary>Noise beyond this number of standard deviations does not bring a surface beyond the range into it.</summary>
    private const double MaxDeviations = 4;

    private ulong _state = Mixed(HashOf(lidar.Name) ^ (ulong)gameFrame);

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

        // Box and Muller's transform of two uniform numbers to a normal one.
        double radius = Math.Sqrt(-2 * Math.Log(1 - Next()));
        return distance + (lidar.RangeNoiseMetres * radius * Math.Cos(2 * Math.PI * Next()));
    }

    /// <summary>Whether the next point gets lost.</summary>
    public bool IsLost() => lidar.DropOutFraction > 0 && Next() < lidar.DropOutFraction;

    /// <summary>The next number of SplitMix64 (Steele, Lea and Flood 2014), from 0 to below 1.</summary>
    private double Next()
    {
        _state = unchecked(_state + 0x9E3779B97F4A7C15);

        // 53 bits, the precision of a double, times 2^-53.
        return (Mixed(_state) >> 11) * (1.0 / (1UL << 53));
    }

    private static ulong Mixed(ulong state)
    {
        unchecked
        {
            ulong mixed = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9;
            mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
            return mixed ^ (mixed >> 31);
        }
    }

    /// <summary>The FNV-1a hash of a name.</summary>
    private static ulong HashOf(string name) =>
        name.Aggregate(0xCBF29CE484222325, static (hash, letter) => unchecked((hash ^ letter) * 0x100000001B3));
}
