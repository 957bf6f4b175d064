using Harvester.Datasets.Detections;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Predictions;

/// <summary>The predictions of a frame that count, and the objects of which they miss or find each.</summary>
/// <param name="Predictions">The predictions.</param>
/// <param name="Found">The objects that a prediction matches.</param>
/// <param name="Missed">The objects that none matches.</param>
internal sealed record FrameOutcome(
    IReadOnlyList<PredictionOutcome> Predictions,
    IReadOnlyList<TruthObject> Found,
    IReadOnlyList<TruthObject> Missed
)
{
    /// <summary>Number of false positives.</summary>
    public int FalsePositives => Predictions.Count(item => item.Kind == OutcomeKind.False);

    /// <summary>Number of misses and false positives.</summary>
    public int Errors => Missed.Count + FalsePositives;

    /// <summary>Joins the outcomes of the classes of a frame.</summary>
    /// <param name="classes">The matches of each class.</param>
    /// <param name="objects">The objects behind the ground truth of each.</param>
    /// <param name="minScore">Smallest score of a prediction that counts.</param>
    public static FrameOutcome Of(IReadOnlyList<ClassMatches> classes, IReadOnlyList<TruthObject[]> objects, double minScore)
    {
        var predictions = new List<PredictionOutcome>();
        var found = new List<TruthObject>();
        var missed = new List<TruthObject>();
        for (int place = 0; place < classes.Count; place++)
        {
            ClassMatches matches = classes[place];
            int[] matched = matches.MatchedBy(CocoThresholds.Overlaps[0], SizeRange.Coco[0]);
            bool[] isFound = new bool[objects[place].Length];
            for (int i = 0; i < matched.Length && matches.Predictions[i].Score >= minScore; i++)
            {
                TruthObject? match = matched[i] == ClassMatches.None ? null : objects[place][matched[i]];
                OutcomeKind kind =
                    matches.IsIgnored(i, matched[i], SizeRange.Coco[0]) ? OutcomeKind.Ignored
                    : match is null ? OutcomeKind.False
                    : OutcomeKind.Matched;
                ObjectLabel? label = kind == OutcomeKind.Matched ? match?.Label : null;
                predictions.Add(new PredictionOutcome(matches.Predictions[i], kind, label?.Id));
                if (kind == OutcomeKind.Matched)
                {
                    isFound[matched[i]] = true;
                }
            }

            for (int i = 0; i < isFound.Length; i++)
            {
                if (!objects[place][i].Box.IsCrowd)
                {
                    (isFound[i] ? found : missed).Add(objects[place][i]);
                }
            }
        }

        return new FrameOutcome(predictions, found, missed);
    }
}
