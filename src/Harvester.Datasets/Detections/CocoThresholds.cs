namespace Harvester.Datasets.Detections;

/// <summary>The parameters of COCO's evaluation of boxes.</summary>
public static class CocoThresholds
{
    /// <summary>Predictions of a class that count in an image: those with the highest scores.</summary>
    public const int MaxPredictions = 100;

    /// <summary>Overlaps from which a prediction matches: 0.5 to 0.95 in steps of 0.05.</summary>
    public static IReadOnlyList<double> Overlaps { get; } = Even(0.5, 0.95, 10);

    /// <summary>Recalls at which precision is read: 0 to 1 in steps of 0.01.</summary>
    public static IReadOnlyList<double> Recalls { get; } = Even(0, 1, 101);

    /// <summary>Numbers of predictions per image and class for which recall is reported.</summary>
    public static IReadOnlyList<int> PredictionCounts { get; } = [1, 10, MaxPredictions];

    /// <summary>
    /// Evenly spaced numbers, rounded as NumPy rounds them: where an overlap or a recall equals a threshold, the last bit decides.
    /// </summary>
    private static double[] Even(double first, double last, int count)
    {
        double step = (last - first) / (count - 1);
        return [.. Enumerable.Range(0, count - 1).Select(index => (index * step) + first), last];
    }
}
