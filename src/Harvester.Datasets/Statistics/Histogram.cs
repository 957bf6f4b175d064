using System;
using System.Collections.Generic;
using System.Linq;

namespace Harvester.Datasets.Statistics;

/// <summary>Counts of numbers in bins.</summary>
public sealed class Histogram
{
    private readonly double[] _starts;
    private readonly int[] _counts;

    /// <summary>Makes an empty histogram whose last bin takes all numbers from its start on.</summary>
    /// <param name="starts">Where each bin begins, rising, in the unit of the numbers.</param>
    public Histogram(params double[] starts)
        : this(starts, null)
    {
    }

    private Histogram(double[] starts, double? end)
    {
        ArgumentNullException.ThrowIfNull(starts);
        if (starts.Length == 0 || starts.Zip(starts.Skip(1)).Any(pair => !(pair.First < pair.Second)))
        {
            throw new ArgumentException("A histogram needs bins that rise.", nameof(starts));
        }

        _starts = starts;
        _counts = new int[starts.Length];
        End = end;
    }

    /// <summary>Where each bin begins; it ends where the next one begins.</summary>
    public IReadOnlyList<double> Starts => _starts;

    /// <summary>Where the last bin ends, itself included; null when it takes all numbers from its start on.</summary>
    public double? End { get; }

    /// <summary>How many numbers fell into each bin.</summary>
    public IReadOnlyList<int> Counts => _counts;

    /// <summary>An empty histogram with bins of one width from 0 up to a number, and a last one for that number and all above.</summary>
    public static Histogram Even(double upTo, int bins) => new([.. Starting(upTo, bins), upTo], null);

    /// <summary>An empty histogram of fractions, with bins of one width from 0 to 1.</summary>
    public static Histogram Fractions(int bins) => new([.. Starting(1, bins)], 1);

    /// <summary>Counts a number; one below the first bin counts in it, and so does one above the end in the last.</summary>
    public void Add(double value)
    {
        int found = Array.BinarySearch(_starts, value);
        _counts[Math.Max(0, found < 0 ? ~found - 1 : found)]++;
    }

    private static IEnumerable<double> Starting(double upTo, int bins) => Enumerable.Range(0, bins).Select(bin => bin * upTo / bins);
}
