namespace Harvester.Datasets.Statistics;

/// <summary>
/// Finds medians without storing the numbers: counts them in bins whose width is 1/4096 of their value. The number of bins depends on the
/// range of the numbers, not on their count.
/// </summary>
internal sealed class QuantileSketch
{
    private const int KeptBits = 12;
    private const int MantissaBits = 52;

    private readonly SortedDictionary<long, (int Count, double Sum)> _bins = [];

    /// <summary>Count of numbers.</summary>
    public int Count { get; private set; }

    /// <summary>Number of bins: at most 4,096 for each doubling of the numbers.</summary>
    public int Bins => _bins.Count;

    /// <summary>The smallest number. There must be at least one number.</summary>
    public double Min { get; private set; } = double.PositiveInfinity;

    /// <summary>
    /// The median, accurate to 1/4096 of its value; of an even count, the mean of the two middle numbers. There must be at least one
    /// number.
    /// </summary>
    public double Median => (At((Count - 1) / 2) + At(Count / 2)) / 2;

    /// <summary>Counts a number; it must be finite and at least 0.</summary>
    public void Add(double value)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(value);
        // The bit patterns of non-negative doubles are ordered as the doubles are, so the highest bits give the bin.
        long bin = BitConverter.DoubleToInt64Bits(value) >> (MantissaBits - KeptBits);
        (int count, double sum) = _bins.GetValueOrDefault(bin);
        _bins[bin] = (count + 1, sum + value);
        Count++;
        Min = Math.Min(Min, value);
    }

    /// <summary>The number at a position of the sorted order, from 0, approximated by the mean of its bin.</summary>
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
