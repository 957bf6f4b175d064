using Harvester.Exports.Predictions;

namespace Harvester.Reports.Sessions;

/// <summary>Chooses the frames of a report.</summary>
internal static class FrameChoice
{
    /// <summary>Evenly spaced frames; with predictions, up to half of them are those with the most errors.</summary>
    /// <param name="count">Number of frames of the session.</param>
    /// <param name="max">Largest number of frames to choose; at least 1.</param>
    /// <param name="predictions">The evaluation of predictions, if there are any.</param>
    /// <returns>Places of frames in the session, ascending.</returns>
    public static IReadOnlyList<int> Of(int count, int max, PredictionEvaluation? predictions)
    {
        if (predictions is null || count <= max)
        {
            return EvenSelection.Of(count, max);
        }

        int[] worst = [.. predictions.WorstFrames(max / 2)];
        return [.. EvenSelection.Of(count, max - worst.Length).Union(worst).Order()];
    }
}
