namespace Harvester.Runs.Evaluation.Scores;

/// <summary>
/// Mean and median of some values, and the percentile bootstrap interval of the mean: 95 %, from 10,000 seeded resamples.
/// </summary>
/// <param name="Mean">The mean.</param>
/// <param name="Median">The median.</param>
/// <param name="Low">Lower end of the mean's interval.</param>
/// <param name="High">Upper end of the mean's interval.</param>
public sealed record MeanInterval(double Mean, double Median, double Low, double High)
{
    private const int Resamples = 10_000;
    private const int Seed = 1;
    private const int Decimals = 4;
    private const double Tail = 0.025;

    /// <summary>Stands for the statistics of no values.</summary>
    public static MeanInterval None { get; } = new(0, 0, 0, 0);

    /// <summary>The statistics of at least one value; of one value, the interval is that value.</summary>
    public static MeanInterval Of(IReadOnlyList<double> values)
    {
        ArgumentNullException.ThrowIfNull(values);
        if (values.Count == 0)
        {
            throw new ArgumentException("A mean takes at least one value.", nameof(values));
        }

        Random random = new(Seed);
        double[] means = new double[Resamples];
        for (int i = 0; i < Resamples; i++)
        {
            double sum = 0;
            for (int n = 0; n < values.Count; n++)
            {
                sum += values[random.Next(values.Count)];
            }

            means[i] = sum / values.Count;
        }

        Array.Sort(means);
        double[] sorted = [.. values.Order()];
        return new MeanInterval(
            Rounded(values.Average()),
            Rounded(Quantile(sorted, 0.5)),
            Rounded(Quantile(means, Tail)),
            Rounded(Quantile(means, 1 - Tail))
        );
    }

    private static double Quantile(double[] sorted, double share)
    {
        double place = share * (sorted.Length - 1);
        int below = (int)place;
        return sorted[below] + ((place - below) * (sorted[Math.Min(below + 1, sorted.Length - 1)] - sorted[below]));
    }

    private static double Rounded(double value) => Math.Round(value, Decimals) + 0.0;
}
