namespace Harvester.Datasets.Detections;

/// <summary>
/// The predictions of one class in one image, matched to its ground truth as COCO defines it. The prediction with the highest score goes
/// first and takes the free box that it overlaps most; boxes outside the size range and ignore regions come last, and what matches them
/// does not count.
/// </summary>
public sealed class ClassMatches
{
    /// <summary>The place of a box that nothing matched.</summary>
    public const int None = -1;

    /// <summary>An overlap of exactly 1 matches any threshold, in spite of rounding.</summary>
    private const double GreatestThreshold = 1 - 1e-10;

    private readonly PredictedBox[] _predictions;
    private readonly TruthBox[] _truth;
    private readonly double[,] _overlaps;
    private readonly bool[] _isIgnored;
    private int[] _order = [];
    private SizeRange? _range;

    /// <summary>Prepares the matching.</summary>
    /// <param name="predictions">Predictions of one class in one image, in the order of their file.</param>
    /// <param name="truth">The boxes of the class in the image.</param>
    public ClassMatches(IEnumerable<PredictedBox> predictions, IEnumerable<TruthBox> truth)
    {
        // OrderByDescending keeps the order of equal scores, as COCO does.
        _predictions = [.. predictions.OrderByDescending(item => item.Score).Take(CocoThresholds.MaxPredictions)];
        _truth = [.. truth];
        _isIgnored = new bool[_truth.Length];
        _overlaps = new double[_predictions.Length, _truth.Length];
        for (int i = 0; i < _predictions.Length; i++)
        {
            for (int j = 0; j < _truth.Length; j++)
            {
                _overlaps[i, j] = _truth[j].OverlapWith(_predictions[i].Box);
            }
        }
    }

    /// <summary>The predictions that count, by falling score.</summary>
    public IReadOnlyList<PredictedBox> Predictions => _predictions;

    /// <summary>The ground truth, in the order given.</summary>
    public IReadOnlyList<TruthBox> Truth => _truth;

    /// <summary>Number of boxes to find: those in a range of sizes that are no ignore regions.</summary>
    public int CountIn(SizeRange range)
    {
        Choose(range);
        return _isIgnored.Count(isIgnored => !isIgnored);
    }

    /// <summary>The place in <see cref="Truth"/> of the box that each prediction matches, or <see cref="None"/>.</summary>
    /// <param name="threshold">Smallest overlap, 0 to 1.</param>
    /// <param name="range">The range of sizes.</param>
    public int[] MatchedBy(double threshold, SizeRange range)
    {
        Choose(range);
        bool[] isTaken = new bool[_truth.Length];
        int[] matches = new int[_predictions.Length];
        for (int i = 0; i < matches.Length; i++)
        {
            int best = BestFor(i, isTaken, Math.Min(threshold, GreatestThreshold));
            matches[i] = best;
            if (best != None)
            {
                isTaken[best] = true;
            }
        }

        return matches;
    }

    /// <summary>Whether a prediction with a match, or without, does not count in a range of sizes.</summary>
    /// <param name="prediction">Its place in <see cref="Predictions"/>.</param>
    /// <param name="match">The place of its match, or <see cref="None"/>.</param>
    /// <param name="range">The range of sizes.</param>
    public bool IsIgnored(int prediction, int match, SizeRange range)
    {
        Choose(range);
        return match == None ? !range.Has(_predictions[prediction].Box.Area) : _isIgnored[match];
    }

    /// <summary>Sorts the boxes for a range of sizes: first those to find, then the others.</summary>
    private void Choose(SizeRange range)
    {
        ArgumentNullException.ThrowIfNull(range);
        if (_range == range)
        {
            return;
        }

        _range = range;
        for (int i = 0; i < _truth.Length; i++)
        {
            _isIgnored[i] = _truth[i].IsCrowd || !range.Has(_truth[i].Area);
        }

        _order = [.. Enumerable.Range(0, _truth.Length).OrderBy(place => _isIgnored[place])];
    }

    private int BestFor(int prediction, bool[] isTaken, double threshold)
    {
        int best = None;
        double overlap = threshold;
        foreach (int place in _order)
        {
            if (isTaken[place] && !_truth[place].IsCrowd)
            {
                continue;
            }

            if (best != None && !_isIgnored[best] && _isIgnored[place])
            {
                break;
            }

            if (_overlaps[prediction, place] >= overlap)
            {
                overlap = _overlaps[prediction, place];
                best = place;
            }
        }

        return best;
    }
}
