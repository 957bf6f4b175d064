namespace Harvester.Reports.Comparison;

/// <summary>
/// A distribution of numbers in little memory: counts and sums in bins whose width is at most 1/1024 of their value, so that the mean of a
/// bin stands for its numbers. The memory depends on the range of the numbers, not on their count.
/// </summary>
public sealed class ValueSketch
{
    private const int KeptBits = 10;
    private const int MantissaBits = 52;

    private readonly Dictionary<long, (long Count, double Sum)> _bins = [];
    private IReadOnlyList<(double Value, long Count)>? _points;

    /// <summary>Count of numbers.</summary>
    public long Count { get; private set; }

    /// <summary>The means of the bins with their counts, ascending.</summary>
    public IReadOnlyList<(double Value, long Count)> Points =>
        _points ??= [.. _bins.OrderBy(bin => bin.Key).Select(bin => (bin.Value.Sum / bin.Value.Count, bin.Value.Count))];

    /// <summary>The mean; null without numbers.</summary>
    public double? Mean => Count == 0 ? null : _bins.Values.Sum(bin => bin.Sum) / Count;

    /// <summary>Counts a number.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not finite.</exception>
    public void Add(double value)
    {
        if (!double.IsFinite(value))
        {
            throw new ArgumentOutOfRangeException(nameof(value), value, "A number of a distribution must be finite.");
        }

        // The bit patterns of non-negative doubles are ordered as the doubles are, so the highest bits give the bin.
        long bin = BitConverter.DoubleToInt64Bits(Math.Abs(value)) >> (MantissaBits - KeptBits);
        long key = value < 0 ? -1 - bin : bin;
        (long count, double sum) = _bins.GetValueOrDefault(key);
        _bins[key] = (count + 1, sum + value);
        Count++;
        _points = null;
    }

    /// <summary>The smallest number that at least a fraction of the numbers do not exceed; null without numbers.</summary>
    /// <param name="fraction">0 to 1.</param>
    public double? Quantile(double fraction)
    {
        long before = 0;
        foreach ((double value, long count) in Points)
        {
            before += count;
            if (before >= fraction * Count)
            {
                return value;
            }
        }

        return null;
    }

    /// <summary>The fraction of the numbers in each bin of a histogram; numbers beyond its ends count in the first or last bin.</summary>
    /// <param name="edges">Ends of the bins, ascending; each bin includes its lower end.</param>
    public double[] Fractions(IReadOnlyList<double> edges)
    {
        ArgumentNullException.ThrowIfNull(edges);
        double[] fractions = new double[edges.Count - 1];
        int bin = 0;
        foreach ((double value, long count) in Points)
        {
            while (bin < fractions.Length - 1 && value >= edges[bin + 1])
            {
                bin++;
            }

            fractions[bin] += (double)count / Count;
        }

        return fractions;
    }
}
