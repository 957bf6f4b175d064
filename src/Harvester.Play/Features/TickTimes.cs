namespace Harvester.Play.Features;

/// <summary>
/// The distribution of times of ticks, in constant memory: a histogram with <see cref="PerDecade"/> classes for each power of ten, so that
/// a percentile is at most 5 % above the true one.
/// </summary>
public sealed class TickTimes
{
    private const int PerDecade = 50;
    private const int Decades = 8;
    private const double MinMilliseconds = 0.001;
    private readonly int[] _counts = new int[(PerDecade * Decades) + 1];

    /// <summary>Number of ticks added.</summary>
    public int Count { get; private set; }

    /// <summary>Adds a tick.</summary>
    /// <param name="milliseconds">0 or more; less than a microsecond counts as one.</param>
    public void Add(double milliseconds)
    {
        double place = PerDecade * Math.Log10(Math.Max(milliseconds, MinMilliseconds) / MinMilliseconds);
        _counts[Math.Min((int)Math.Ceiling(place), _counts.Length - 1)]++;
        Count++;
    }

    /// <summary>The time that a fraction of the ticks did not exceed, milliseconds; 0 without ticks.</summary>
    /// <param name="share">0 to 1: 0.99 for the 99th percentile.</param>
    public double Percentile(double share)
    {
        int wanted = Math.Max(1, (int)Math.Ceiling(share * Count));
        int sum = 0;
        int place = Enumerable.Range(0, _counts.Length).FirstOrDefault(index => (sum += _counts[index]) >= wanted);
        return Count == 0 ? 0 : MinMilliseconds * Math.Pow(10, (double)place / PerDecade);
    }
}
