namespace Harvester.Runs.Evaluation.Scores;

/// <summary>Garwood's exact interval for the mean of a Poisson distribution of which a number of events was observed.</summary>
/// <param name="Low">Lower end.</param>
/// <param name="High">Upper end.</param>
public readonly record struct PoissonInterval(double Low, double High)
{
    private const int Halvings = 100;

    /// <summary>The interval that covers the mean with at least a given probability.</summary>
    /// <param name="events">Number of events, 0 or more.</param>
    /// <param name="confidence">Probability, between 0 and 1.</param>
    public static PoissonInterval Of(int events, double confidence = 0.95)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(events);
        double tail = (1 - confidence) / 2;
        double low = events == 0 ? 0 : MeanFrom(mean => 1 - AtMost(events - 1, mean) > tail, events);
        return new PoissonInterval(low, MeanFrom(mean => AtMost(events, mean) < tail, events));
    }

    /// <summary>Probability of at most a number of events.</summary>
    private static double AtMost(int events, double mean)
    {
        double term = 1;
        double sum = 1;
        for (int n = 1; n <= events; n++)
        {
            term *= mean / n;
            sum += term;
            if (sum > 1e200)
            {
                // The sum would overflow for hundreds of events; the common factor is taken out.
                return Math.Min(1, Math.Exp(LogOfSum(events, mean) - mean));
            }
        }

        return Math.Min(1, sum * Math.Exp(-mean));
    }

    private static double LogOfSum(int events, double mean)
    {
        // Backwards from the last term, relative to it: mean^k / k! · (1 + k/mean + k(k-1)/mean² + ...).
        double log = 0;
        for (int n = 1; n <= events; n++)
        {
            log += Math.Log(mean / n);
        }

        double term = 1;
        double sum = 1;
        for (int n = events; n > 0; n--)
        {
            term *= n / mean;
            sum += term;
        }

        return log + Math.Log(sum);
    }

    /// <summary>The mean from which a condition holds, by bisection.</summary>
    private static double MeanFrom(Func<double, bool> holds, int events)
    {
        double low = 0;
        double high = (2 * events) + 20;
        for (int i = 0; i < Halvings; i++)
        {
            double middle = (low + high) / 2;
            (low, high) = holds(middle) ? (low, middle) : (middle, high);
        }

        return (low + high) / 2;
    }
}
