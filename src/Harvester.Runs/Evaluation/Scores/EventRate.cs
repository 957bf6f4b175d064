namespace Harvester.Runs.Evaluation.Scores;

/// <summary>Events of a drive per kilometre, with Garwood's exact 95 % interval.</summary>
/// <param name="Name">What the events are.</param>
/// <param name="Events">Number of events.</param>
/// <param name="Kilometres">Distance in which they were counted.</param>
/// <param name="PerKilometre">Events per kilometre; null without a distance.</param>
/// <param name="Low">Lower end of the interval.</param>
/// <param name="High">Upper end of the interval.</param>
public sealed record EventRate(string Name, int Events, double Kilometres, double? PerKilometre, double? Low, double? High)
{
    private const int Decimals = 4;

    /// <summary>The rate of a number of events in a distance, metres.</summary>
    public static EventRate Of(string name, int events, double metres)
    {
        PoissonInterval interval = PoissonInterval.Of(events);
        double kilometres = metres / 1000;
        return new EventRate(name, events, Rounded(kilometres), Per(events), Per(interval.Low), Per(interval.High));

        double? Per(double count) => kilometres > 0 ? Rounded(count / kilometres) : null;
    }

    private static double Rounded(double value) => Math.Round(value, Decimals) + 0.0;
}
