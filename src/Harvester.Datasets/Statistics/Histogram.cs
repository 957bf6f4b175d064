using System;
using System.Collections.Generic;
using System.Linq;

namespace Harvester.Datasets.Statistics;

/// <summary>Counts of numbers in bins. The last bin takes whatever lies above.</summary>
public sealed class Histogram
{
    private readonly double[] _starts;
    private readonly int[] _counts;

    /// <summary>Makes an empty histogram.</summary>
    /// <param name="starts">Where each bin begins, rising, in the unit of the numbers.</param>
    public Histogram(params double[] starts)
    {
        ArgumentNullException.ThrowIfNull(starts);
        if (starts.Length == 0 || starts.Zip(starts.Skip(1)).Any(pair => !(pair.First < pair.Second)))
        {
            throw new ArgumentException("A histogram needs bins that rise.", nameof(starts));
        }

        _starts = starts;
        _counts = new int[starts.Length];
    }

    /// <summary>Where each bin begins; it ends where the next one begins.</summary>
    public IReadOnlyList<double> Starts => _starts;

    /// <summary>How many numbers fell into each bin.</summary>
    public IReadOnlyList<int> Counts => _counts;

    /// <summary>An empty histogram with bins of one width, from 0 up to a number.</summary>
    public static Histogram Even(double upTo, int bins) => new([.. Enumerable.Range(0, bins).Select(bin => bin * upTo / bins)]);

    /// <summary>Counts a number; one below the first bin counts in it.</summary>
    public void Add(double value)
    {
        int found = Array.BinarySearch(_starts, value);
        _counts[Math.Max(0, found < 0 ? ~found - 1 : found)]++;
    }
}
