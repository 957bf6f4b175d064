using Harvester.Datasets.Detections;
using Harvester.Exports.Assembly;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Predictions;

/// <summary>How well predictions agree with a session, by COCO's definitions.</summary>
public sealed class PredictionEvaluation
{
    private readonly PredictionSource _source;
    private readonly double _minScore;
    private readonly ClassTally[] _tallies;
    private readonly List<int> _errors = [];

    private PredictionEvaluation(PredictionSource source, double minScore)
    {
        _source = source;
        _minScore = minScore;
        _tallies = [.. source.Predictions.Classes.Select(_ => new ClassTally())];
        Groups = new OutcomeGroups(source.Predictions.Classes.Select(kind => kind.Name));
    }

    /// <summary>The format of the predictions: COCO or KITTI.</summary>
    public string Format => _source.Predictions.Format;

    /// <summary>Smallest score of a prediction that counts as a match or false positive; precision and recall use all.</summary>
    public double MinScore => _minScore;

    /// <summary>The classes.</summary>
    public IReadOnlyList<PredictedClass> Classes => _source.Predictions.Classes;

    /// <summary>Precision and recall of each class.</summary>
    public IReadOnlyList<ClassTally> Tallies => _tallies;

    /// <summary>Matches, misses and false positives at an overlap of 0.5.</summary>
    public OutcomeGroups Groups { get; }

    /// <summary>Number of misses and false positives of each frame, in the order of the session.</summary>
    public IReadOnlyList<int> ErrorsOfFrames => _errors;

    /// <summary>Added to x and y, moves a predicted box to the pixels of the session.</summary>
    internal double ToSessionPixels => _source.Predictions.ToSessionPixels;

    /// <summary>Evaluates predictions.</summary>
    /// <param name="session">The session.</param>
    /// <param name="path">A file with COCO results, or a folder with KITTI results.</param>
    /// <param name="minScore">Smallest score of a prediction that counts as a match or false positive.</param>
    /// <param name="report">Receives the number of frames after each frame.</param>
    /// <param name="cancellation">Stops between two frames.</param>
    /// <exception cref="DatasetFormatException">The predictions or the session are malformed, or do not belong together.</exception>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public static PredictionEvaluation Of(
        SessionReader session,
        string path,
        double minScore,
        Action<int>? report = null,
        CancellationToken cancellation = default
    )
    {
        var evaluation = new PredictionEvaluation(PredictionSource.Open(session, path, cancellation), minScore);
        evaluation.Run(report, cancellation);
        return evaluation;
    }

    /// <summary>The mean over the classes that have a value; null if none has.</summary>
    public double? MeanOf(Func<ClassTally, double?> figure) => _tallies.Select(figure).Average();

    /// <summary>The frames with the most errors first; frames without errors are left out.</summary>
    /// <param name="count">Largest number of frames.</param>
    /// <returns>Places of the frames in the session, from 0.</returns>
    public IEnumerable<int> WorstFrames(int count) =>
        _errors
            .Index()
            .Where(frame => frame.Item > 0)
            .OrderByDescending(frame => frame.Item)
            .ThenBy(frame => frame.Index)
            .Take(count)
            .Select(frame => frame.Index);

    /// <summary>The outcomes of some frames, by their places in the session. A frame that the export does not label has none.</summary>
    /// <param name="places">Ascending places, from 0.</param>
    internal IReadOnlyDictionary<int, FrameOutcome> OutcomesOf(IReadOnlyCollection<int> places)
    {
        HashSet<int> chosen = [.. places];
        var outcomes = new Dictionary<int, FrameOutcome>();
        foreach (ExportFrame frame in PlannedFrames.Of(_source.Plan).Where(frame => chosen.Contains(frame.Index)))
        {
            if (_source.Predictions.ImageOf(frame) is { } image)
            {
                (ClassMatches[] matches, TruthObject[][] objects) = Match(frame, image);
                outcomes[frame.Index] = FrameOutcome.Of(matches, objects, _minScore);
            }
        }

        return outcomes;
    }

    private void Run(Action<int>? report, CancellationToken cancellation)
    {
        var images = new HashSet<int>();
        foreach (ExportFrame frame in PlannedFrames.Of(_source.Plan))
        {
            cancellation.ThrowIfCancellationRequested();
            int errors = 0;
            if (_source.Predictions.ImageOf(frame) is { } image)
            {
                images.Add(image);
                errors = Add(frame, image);
            }

            _errors.Add(errors);
            report?.Invoke(_errors.Count);
        }

        _source.Predictions.CheckImages(images);
    }

    private int Add(ExportFrame frame, int image)
    {
        (ClassMatches[] matches, TruthObject[][] objects) = Match(frame, image);
        for (int place = 0; place < matches.Length; place++)
        {
            _tallies[place].Add(matches[place]);
        }

        FrameOutcome outcome = FrameOutcome.Of(matches, objects, _minScore);
        Groups.Add(outcome);
        return outcome.Errors;
    }

    /// <summary>The matches of each class, and the objects behind its ground truth.</summary>
    private (ClassMatches[] Matches, TruthObject[][] Objects) Match(ExportFrame frame, int image)
    {
        ILookup<int, TruthObject> truth = _source.Predictions.TruthOf(frame).ToLookup(item => item.Box.Class);
        ILookup<int, PredictedBox> predictions = _source.Predictions.For(image).ToLookup(item => item.Class);
        TruthObject[][] objects = [.. Classes.Select((_, place) => truth[place].ToArray())];
        return ([.. objects.Select((items, place) => new ClassMatches(predictions[place], items.Select(item => item.Box)))], objects);
    }
}
