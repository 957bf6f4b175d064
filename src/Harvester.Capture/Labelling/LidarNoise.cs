using System;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Labelling;

/// <summary>The errors of a LiDAR at one moment: noise of the distance and lost points. The same moment has the same errors.</summary>
internal sealed class LidarNoise(RigLidar lidar, long gameFrame)
{
    /// <summary>Noise beyond this number of standard deviations does not bring a surface beyond the range into it.</summary>
    private const double MaxDeviations = 4;

    private ulong _state = unchecked((ulong)gameFrame * 0x9E3779B97F4A7C15);

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
        unchecked
        {
            _state += 0x9E3779B97F4A7C15;
            ulong mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9;
            mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
            return ((mixed ^ (mixed >> 31)) >> 11) * (1.0 / (1UL << 53));
        }
    }
}
