using Harvester.Datasets.Logs;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>The tracks of a scenario whose future is to be predicted.</summary>
internal static class PredictionTargets
{
    /// <summary>WOMD names at most this many.</summary>
    private const int Count = 8;

    /// <summary>Who moves less from the present to the end has no future to predict, metres.</summary>
    private const double MinPath = 1;

    /// <summary>The step that is the present.</summary>
    public static int PresentOf(MotionLog log) => Math.Min(ScenarioWindow.Present, log.Times.Count - 1);

    /// <summary>
    /// Indices of the tracks nearest to the ego at present among those, the ego excepted, that are known from there to the end and move.
    /// </summary>
    public static IEnumerable<int> Of(MotionLog log)
    {
        int present = PresentOf(log);
        if (present < 0 || log.Ego < 0 || log.Tracks[log.Ego].States[present] is not { } ego)
        {
            return [];
        }

        return Enumerable
            .Range(0, log.Tracks.Count)
            .Where(index => index != log.Ego && log.Tracks[index].States.Skip(present).All(state => state is not null))
            .Where(index =>
                (log.Tracks[index].States[^1]!.Value.Centre - log.Tracks[index].States[present]!.Value.Centre).Length >= MinPath
            )
            .OrderBy(index => (log.Tracks[index].States[present]!.Value.Centre - ego.Centre).Length)
            .Take(Count)
            .Order();
    }
}
