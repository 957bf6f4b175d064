using Harvester.Pages;
using Harvester.Runs.Evaluation.Scores;

namespace Harvester.Runs.Evaluation.Reports;

/// <summary>A table with a row for each episode.</summary>
internal static class EpisodeTable
{
    private static readonly string[] Heads =
    [
        "episode",
        "score",
        "route",
        "end",
        "departures",
        "vehicles hit",
        "parked",
        "pedestrians",
        "red lights",
        "stop signs",
        "stuck",
    ];

    public static void Write(MarkupWriter page, IReadOnlyList<DriveEpisode> episodes)
    {
        page.Start("section").Start("table").With("class", "episodes").NewLine().Start("tr");
        foreach (string head in Heads)
        {
            page.Element("th", head);
        }

        page.End().NewLine();
        foreach (DriveEpisode episode in episodes)
        {
            EpisodeScore score = episode.Score;
            page.Start("tr")
                .Element("td", episode.Name)
                .Element("td", FormattableString.Invariant($"{score.DrivingScore:0.0}"))
                .Element("td", FormattableString.Invariant($"{100 * score.RouteCompletionFraction:0.0} %"))
                .Element("td", episode.Ending);
            foreach (
                int count in new[]
                {
                    episode.Figures.LaneDepartures,
                    score.Collisions.Vehicles,
                    score.Collisions.Parked,
                    score.Collisions.Pedestrians,
                    score.RedLights,
                    score.StopSigns,
                    score.Stuck,
                }
            )
            {
                page.Element("td", FormattableString.Invariant($"{count}"));
            }

            page.End().NewLine();
        }

        page.End().End().NewLine();
    }
}
