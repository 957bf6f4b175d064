namespace Harvester.Datasets.Detections;

/// <summary>
/// The outcome of all predictions of one class, from which precision and recall follow. It holds 24 bytes per prediction, so a session of
/// any length is evaluated image by image.
/// </summary>
public sealed class ClassTally
{
    private const int BitsPerRange = 16;

    private readonly List<Outcome> _outcomes = [];
    private readonly int[] _counts = new int[SizeRange.Coco.Count];
    private readonly int[,] _found = new int[CocoThresholds.PredictionCounts.Count, CocoThresholds.Overlaps.Count];
    private Outcome[]? _sorted;

    /// <summary>Number of boxes to find in a range of sizes.</summary>
    /// <param name="range">Index in <see cref="SizeRange.Coco"/>.</param>
    public int CountIn(int range) => _counts[range];

    /// <summary>Adds the matches of an image. Images are added in the order of their numbers, which decides between equal scores.</summary>
    public void Add(ClassMatches matches)
    {
        ArgumentNullException.ThrowIfNull(matches);
        var outcomes = new Outcome[matches.Predictions.Count];
        for (int i = 0; i < outcomes.Length; i++)
        {
            outcomes[i].Score = matches.Predictions[i].Score;
        }

        for (int range = 0; range < SizeRange.Coco.Count; range++)
        {
            SizeRange sizes = SizeRange.Coco[range];
            _counts[range] += matches.CountIn(sizes);
            for (int step = 0; outcomes.Length > 0 && step < CocoThresholds.Overlaps.Count; step++)
            {
                int[] matched = matches.MatchedBy(CocoThresholds.Overlaps[step], sizes);
                ulong bit = 1UL << ((range * BitsPerRange) + step);
                for (int i = 0; i < outcomes.Length; i++)
                {
                    bool isMatched = matched[i] != ClassMatches.None;
                    bool isIgnored = matches.IsIgnored(i, matched[i], sizes);
                    outcomes[i].Matched |= isMatched ? bit : 0;
                    outcomes[i].Ignored |= isIgnored ? bit : 0;
                    for (int limit = 0; range == 0 && isMatched && !isIgnored && limit < CocoThresholds.PredictionCounts.Count; limit++)
                    {
                        _found[limit, step] += i < CocoThresholds.PredictionCounts[limit] ? 1 : 0;
                    }
                }
            }
        }

        _outcomes.AddRange(outcomes);
        _sorted = null;
    }

    /// <summary>Average precision over all overlaps, 0 to 1; null if there is no box to find.</summary>
    /// <param name="range">Index in <see cref="SizeRange.Coco"/>.</param>
    public double? AveragePrecision(int range) =>
        CountIn(range) == 0 ? null : Enumerable.Range(0, CocoThresholds.Overlaps.Count).Average(step => Precisions(step, range).Average());

    /// <summary>Average precision at one overlap, 0 to 1; null if there is no box to find.</summary>
    /// <param name="overlap">Index in <see cref="CocoThresholds.Overlaps"/>.</param>
    public double? AveragePrecisionAt(int overlap) => CountIn(0) == 0 ? null : Precisions(overlap, 0).Average();

    /// <summary>Average recall over all overlaps, for boxes of all sizes, 0 to 1; null if there is no box to find.</summary>
    /// <param name="limit">Index in <see cref="CocoThresholds.PredictionCounts"/>.</param>
    public double? AverageRecall(int limit) =>
        CountIn(0) == 0
            ? null
            : Enumerable.Range(0, CocoThresholds.Overlaps.Count).Average(step => (double)_found[limit, step] / CountIn(0));

    /// <summary>Average recall over all overlaps in a range of sizes, 0 to 1; null if there is no box to find.</summary>
    /// <param name="range">Index in <see cref="SizeRange.Coco"/>.</param>
    public double? AverageRecallIn(int range) =>
        CountIn(range) == 0
            ? null
            : Enumerable
                .Range(0, CocoThresholds.Overlaps.Count)
                .Average(step =>
                {
                    ulong bit = 1UL << ((range * BitsPerRange) + step);
                    return (double)_outcomes.Count(outcome => (outcome.Matched & bit) != 0 && (outcome.Ignored & bit) == 0)
                        / CountIn(range);
                });

    /// <summary>
    /// Precision at each of <see cref="CocoThresholds.Recalls"/>: the highest precision at that recall or a higher one, 0 where it is not
    /// reached.
    /// </summary>
    /// <param name="overlap">Index in <see cref="CocoThresholds.Overlaps"/>.</param>
    /// <param name="range">Index in <see cref="SizeRange.Coco"/>.</param>
    public double[] Precisions(int overlap, int range = 0)
    {
        double[] precisions = new double[CocoThresholds.Recalls.Count];
        (List<double> recalls, List<double> values) = Curve(1UL << ((range * BitsPerRange) + overlap), CountIn(range));
        for (int i = values.Count - 1; i > 0; i--)
        {
            values[i - 1] = Math.Max(values[i - 1], values[i]);
        }

        int place = 0;
        for (int step = 0; step < precisions.Length; step++)
        {
            while (place < recalls.Count && recalls[place] < CocoThresholds.Recalls[step])
            {
                place++;
            }

            precisions[step] = place < recalls.Count ? values[place] : 0;
        }

        return precisions;
    }

    /// <summary>Recall and precision after each prediction that counts, by falling score.</summary>
    private (List<double> Recalls, List<double> Precisions) Curve(ulong bit, int count)
    {
        _sorted ??= [.. _outcomes.OrderByDescending(outcome => outcome.Score)];
        var recalls = new List<double>();
        var precisions = new List<double>();
        int found = 0;
        int all = 0;
        foreach (Outcome outcome in _sorted)
        {
            if ((outcome.Ignored & bit) == 0)
            {
                found += (outcome.Matched & bit) == 0 ? 0 : 1;
                all++;
                recalls.Add(count == 0 ? 0 : (double)found / count);
                precisions.Add((double)found / all);
            }
        }

        return (recalls, precisions);
    }

    private record struct Outcome(double Score, ulong Matched, ulong Ignored);
}
