using System;
using System.Collections.Generic;

namespace Harvester.Datasets.Statistics;

/// <summary>Counts of numbers in bins of one width, from 0 up. The last bin takes whatever lies above.</summary>
public sealed class Histogram
{
    private readonly int[] _counts;

    /// <summary>Makes an empty histogram.</summary>
    /// <param name="binWidth">Width of a bin, in the unit of the numbers; greater than 0.</param>
    /// <param name="bins">Number of bins, at least 1.</param>
    public Histogram(double binWidth, int bins)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(binWidth);
        ArgumentOutOfRangeException.ThrowIfLessThan(bins, 1);
        BinWidth = binWidth;
        _counts = new int[bins];
    }

    /// <summary>Width of a bin, in the unit of the numbers.</summary>
    public double BinWidth { get; }

    /// <summary>How many numbers fell into each bin; bin i reaches from i to i + 1 widths.</summary>
    public IReadOnlyList<int> Counts => _counts;

    /// <summary>Counts a number; one below 0 counts as 0.</summary>
    public void Add(double value) => _counts[(int)Math.Clamp(value / BinWidth, 0, _counts.Length - 1)]++;
}
