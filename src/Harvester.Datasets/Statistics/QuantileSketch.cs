using System;
using System.Collections.Generic;

namespace Harvester.Datasets.Statistics;

/// <summary>
/// Finds medians without keeping the numbers: it counts them in bins that are 1/4096 of their numbers wide, so that their number depends on
/// how far the numbers spread, not on how many there are.
/// </summary>
internal sealed class QuantileSketch
{
    private const int KeptBits = 12;
    private const int MantissaBits = 52;

    private readonly SortedDictionary<long, (int Count, double Sum)> _bins = [];

    /// <summary>How many numbers it has counted.</summary>
    public int Count { get; private set; }

    /// <summary>How many bins it holds: 4,096 at most for each doubling of the numbers.</summary>
    public int Bins => _bins.Count;

    /// <summary>The least number. There must be one.</summary>
    public double Least { get; private set; } = double.PositiveInfinity;

    /// <summary>The median, of an even count the mean of the two in the middle; at most 1/4096 of it off. There must be a number.</summary>
    public double Median => (At((Count - 1) / 2) + At(Count / 2)) / 2;

    /// <summary>Counts a number, finite and at least 0.</summary>
    public void Add(double value)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(value);
        // The bits of doubles that are not negative rise as the doubles do: the highest ones say the bin.
        long bin = BitConverter.DoubleToInt64Bits(value) >> (MantissaBits - KeptBits);
        (int count, double sum) = _bins.GetValueOrDefault(bin);
        _bins[bin] = (count + 1, sum + value);
        Count++;
        Least = Math.Min(Least, value);
    }

    /// <summary>The number at a place in the order, from 0: the mean of its bin.</summary>
    private double At(int place)
    {
        int before = 0;
        foreach ((int count, double sum) in _bins.Values)
        {
            before += count;
            if (before > place)
            {
                return sum / count;
            }
        }

        throw new InvalidOperationException("There are no numbers.");
    }
}
