namespace Harvester.Datasets.Statistics;

/// <summary>A histogram: counts of numbers in bins.</summary>
public sealed class Histogram
{
    private readonly double[] _starts;
    private readonly int[] _counts;

    /// <summary>Creates an empty histogram whose last bin has no upper end.</summary>
    /// <param name="starts">Lower ends of the bins, ascending, in the unit of the numbers.</param>
    public Histogram(params double[] starts)
        : this(starts, null) { }

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

    /// <summary>Lower ends of the bins; a bin ends where the next one begins.</summary>
    public IReadOnlyList<double> Starts => _starts;

    /// <summary>Upper end of the last bin, inclusive; null if it has none.</summary>
    public double? End { get; }

    /// <summary>Count of numbers in each bin.</summary>
    public IReadOnlyList<int> Counts => _counts;

    /// <summary>An empty histogram with bins of equal width from 0, and a last bin without upper end.</summary>
    public static Histogram Even(double upTo, int bins) => new([.. Starting(upTo, bins), upTo], null);

    /// <summary>An empty histogram of fractions, with bins of equal width from 0 to 1.</summary>
    public static Histogram Fractions(int bins) => new([.. Starting(1, bins)], 1);

    /// <summary>Counts a number. Numbers below the first bin count in the first, numbers above the last bin in the last.</summary>
    public void Add(double value)
    {
        int found = Array.BinarySearch(_starts, value);
        _counts[Math.Max(0, found < 0 ? ~found - 1 : found)]++;
    }

    private static IEnumerable<double> Starting(double upTo, int bins) => Enumerable.Range(0, bins).Select(bin => bin * upTo / bins);
}
