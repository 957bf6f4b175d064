using Harvester.Geometry;
using Harvester.Pages.Plots;
using Harvester.Runs.Evaluation.Scores;

namespace Harvester.Runs.Evaluation.Reports;

/// <summary>The empirical distribution function of the driving scores.</summary>
internal static class ScorePlot
{
    public static LinePlot Of(IReadOnlyList<DriveEpisode> episodes)
    {
        DriveEpisode[] sorted = [.. episodes.OrderBy(episode => episode.Score.DrivingScore)];
        var plot = new LinePlot(PlotAxis.Around("driving score", 0, 100), PlotAxis.Around("share of the episodes", 0, 1));
        List<Vector2D> steps = [new(0, 0)];
        for (int i = 0; i < sorted.Length; i++)
        {
            double score = sorted[i].Score.DrivingScore;
            steps.Add(new Vector2D(score, (double)i / sorted.Length));
            steps.Add(new Vector2D(score, (i + 1.0) / sorted.Length));
        }

        steps.Add(new Vector2D(100, 1));
        plot.Add(new PlotLine(DrivePlots.ByController, steps));
        for (int i = 0; i < sorted.Length; i++)
        {
            double score = sorted[i].Score.DrivingScore;
            plot.Add(
                new PlotMark(
                    DrivePlots.ByBuiltInDriver,
                    new Vector2D(score, (i + 1.0) / sorted.Length),
                    $"{sorted[i].Name}: " + FormattableString.Invariant($"{score:0.0}")
                )
            );
        }

        return plot;
    }
}
