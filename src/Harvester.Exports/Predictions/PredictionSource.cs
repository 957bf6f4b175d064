using Harvester.Exports.Assembly;
using Harvester.Exports.Formats;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Predictions;

/// <summary>Opens predictions for a session: a folder is in KITTI's format, a file in COCO's.</summary>
internal sealed class PredictionSource
{
    private PredictionSource(ExportPlan plan, IPredictions predictions)
    {
        Plan = plan;
        Predictions = predictions;
    }

    /// <summary>The export that the ground truth is taken from: with the default options of its format.</summary>
    public ExportPlan Plan { get; }

    /// <summary>The predictions.</summary>
    public IPredictions Predictions { get; }

    /// <summary>Opens predictions.</summary>
    /// <exception cref="DatasetFormatException">They are malformed, or the session cannot be exported in their format.</exception>
    /// <exception cref="IOException">A file is missing or cannot be read.</exception>
    public static PredictionSource Open(SessionReader session, string path, CancellationToken cancellation)
    {
        bool isFolder = Directory.Exists(path);
        if (!isFolder && !File.Exists(path))
        {
            throw new FileNotFoundException($"File not found: '{path}'.");
        }

        var asked = new ExportPlan(DatasetFormats.Find(isFolder ? "kitti" : "coco")!, [session], new ExportOptions());
        SessionSurvey survey = SessionSurvey.Of(asked, cancellation);
        ExportPlan plan = survey.Decide();
        survey.Check();
        return new PredictionSource(
            plan,
            isFolder ? KittiPredictions.Open(path, plan.Options) : CocoPredictions.Read(path, session.CountLines(), plan.Options)
        );
    }
}
