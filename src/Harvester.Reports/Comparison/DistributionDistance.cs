namespace Harvester.Reports.Comparison;

/// <summary>Distances between two distributions; docs/compare.md has the definitions.</summary>
public static class DistributionDistance
{
    /// <summary>
    /// The 1-Wasserstein distance, in the unit of the numbers: the integral of the absolute difference of the cumulative distributions.
    /// Null if one has no numbers.
    /// </summary>
    public static double? Wasserstein(ValueSketch first, ValueSketch second)
    {
        (double Difference, double Length)[]? pieces = Pieces(first, second);
        return pieces?.Sum(piece => Math.Abs(piece.Difference) * piece.Length);
    }

    /// <summary>
    /// The 1-Wasserstein distance on a circle: the smallest mean way, in either direction. It is the integral above after the median of the
    /// difference is subtracted (Rabin, Delon, Gousseau 2011). Null if one has no numbers.
    /// </summary>
    /// <param name="first">Numbers within one turn.</param>
    /// <param name="second">Numbers within the same turn.</param>
    /// <param name="turn">Length of a turn, in the unit of the numbers.</param>
    public static double? WassersteinOnCircle(ValueSketch first, ValueSketch second, double turn)
    {
        if (Pieces(first, second) is not { } inner)
        {
            return null;
        }

        // From the last number round to the first, both cumulative distributions are complete.
        (double Difference, double Length)[] pieces =
        [
            .. inner.Append((Difference: 0.0, Length: turn - inner.Sum(piece => piece.Length))).OrderBy(piece => piece.Difference),
        ];
        double before = 0;
        double median = 0;
        foreach ((double difference, double length) in pieces)
        {
            before += length;
            median = difference;
            if (before >= turn / 2)
            {
                break;
            }
        }

        return pieces.Sum(piece => Math.Abs(piece.Difference - median) * piece.Length);
    }

    /// <summary>Total variation: half of the sum of the absolute differences, 0 for equal to 1 for disjoint distributions.</summary>
    /// <param name="first">Fractions that add up to 1.</param>
    /// <param name="second">Fractions of the same bins or classes.</param>
    public static double TotalVariation(IReadOnlyList<double> first, IReadOnlyList<double> second) =>
        first.Zip(second).Sum(pair => Math.Abs(pair.First - pair.Second)) / 2;

    /// <summary>
    /// Jensen-Shannon divergence in bits: the mean Kullback-Leibler divergence from the average of both (Lin 1991), 0 for equal to 1 for
    /// disjoint distributions.
    /// </summary>
    /// <param name="first">Fractions that add up to 1.</param>
    /// <param name="second">Fractions of the same bins or classes.</param>
    public static double JensenShannon(IReadOnlyList<double> first, IReadOnlyList<double> second) =>
        first.Zip(second).Sum(pair => (Term(pair.First, pair.Second) + Term(pair.Second, pair.First)) / 2);

    private static double Term(double share, double other) => share == 0 ? 0 : share * Math.Log2(2 * share / (share + other));

    /// <summary>The difference of the cumulative distributions between neighbouring numbers; null if one has no numbers.</summary>
    private static (double Difference, double Length)[]? Pieces(ValueSketch first, ValueSketch second)
    {
        ArgumentNullException.ThrowIfNull(first);
        ArgumentNullException.ThrowIfNull(second);
        if (first.Count == 0 || second.Count == 0)
        {
            return null;
        }

        (double Value, double Step)[] steps =
        [
            .. first
                .Points.Select(point => (point.Value, (double)point.Count / first.Count))
                .Concat(second.Points.Select(point => (point.Value, -(double)point.Count / second.Count)))
                .OrderBy(step => step.Value),
        ];
        var pieces = new (double Difference, double Length)[steps.Length - 1];
        double difference = 0;
        for (int i = 0; i < pieces.Length; i++)
        {
            difference += steps[i].Step;
            pieces[i] = (difference, steps[i + 1].Value - steps[i].Value);
        }

        return pieces;
    }
}
