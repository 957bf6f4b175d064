using Harvester.Pages;
using Harvester.Pages.Plots;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Runs.Evaluation.Scores;

namespace Harvester.Runs.Evaluation.Reports;

/// <summary>Shows a drive as one HTML page: its figures, a map, and plots of lateral error, speed, jerk and progress.</summary>
public static class DriveReport
{
    /// <summary>Name of the file.</summary>
    public const string FileName = "report.html";

    private const string Style = """
        body { max-width: 1060px; }
        table { width: auto; } td { text-align: left; white-space: normal; } td + td { padding-left: 24px; }
        .figures tr:first-child td { border-top: 0; } .episodes td { text-align: right; }
        .panels { grid-template-columns: minmax(0, 1fr); } figure .hint { margin-bottom: 10px; }
        .controller { stroke: var(--accent); } .builtin { stroke: #9aa4ae; } .bound { stroke: #cf8a00; stroke-dasharray: 5 4; }
        .departure { stroke: #cf8a00; } .collision { stroke: #cf222e; }
        b.controller { color: var(--accent); } b.builtin { color: #7d868f; } b.departure { color: #b27700; } b.collision { color: #cf222e; }

        """;

    /// <summary>Writes the page.</summary>
    /// <param name="stream">Receives the page; stays open.</param>
    /// <param name="record">The drives.</param>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public static void Write(Stream stream, DriveRecord record)
    {
        ArgumentNullException.ThrowIfNull(record);
        string title = $"Drive by {record.Settings["controller"]}";
        HtmlPage.Write(
            stream,
            title,
            Style,
            page =>
            {
                page.Start("header").NewLine().Element("h1", title).NewLine();
                WriteSettings(page, record.Settings);
                page.End().NewLine().Start("main").With("class", "panels").NewLine();
                WriteFigures(page, record);
                if (record.Episodes.Count > 1)
                {
                    EpisodeTable.Write(page, record.Episodes);
                    WriteFigure(
                        page,
                        "Distribution of the driving score",
                        "Share of the episodes with at most this score; a ring for each episode.",
                        ScorePlot.Of(record.Episodes)
                    );
                }

                int[] drawn = [.. Enumerable.Range(0, record.Episodes.Count).Where(i => record.Episodes[i].Samples.Count > 1)];
                if (drawn.Length > 0)
                {
                    WritePlots(page, record, drawn.MinBy(i => record.Episodes[i].Score.DrivingScore));
                }

                page.End().NewLine();
            }
        );
    }

    private static void WriteSettings(MarkupWriter page, IReadOnlyDictionary<string, string> settings)
    {
        page.Start("dl").With("class", "facts").NewLine();
        foreach ((string key, string value) in settings)
        {
            (string name, string text) = SettingLabel.Of(key, value);
            page.Start("div").Element("dt", name).Element("dd", text).End().NewLine();
        }

        page.End().NewLine();
    }

    private static void WriteFigures(MarkupWriter page, DriveRecord record)
    {
        page.Start("section").Start("table").With("class", "figures").NewLine();
        foreach ((string name, string value) in record.Figures.Rows().Concat(record.Summary.Rows()))
        {
            page.Start("tr").Element("td", name).Element("td", value).End().NewLine();
        }

        page.End().End().NewLine();
    }

    private static void WritePlots(MarkupWriter page, DriveRecord record, int episode)
    {
        DrivePlots plots = new(record.Episodes[episode].Samples);
        if (record.Episodes.Count > 1)
        {
            page.Element("p", $"The plots below show the episode with the lowest score: {record.Episodes[episode].Name}.").NewLine();
        }

        StartFigure(page, "Map");
        page.Start("p").With("class", "hint");
        WriteKey(page, DrivePlots.ByController, "The controller").Text(" drives where lanes are known; the ");
        WriteKey(page, DrivePlots.ByBuiltInDriver, "built-in driver")
            .Text(" drives through junctions and where it has to give way. Rings mark ");
        WriteKey(page, DrivePlots.Departure, "lane departures").Text(" and ");
        WriteKey(page, DrivePlots.Collision, "collisions").Text(".").End().NewLine();
        plots.Map(EventsIn(record.Departures), EventsIn(record.Collisions)).Write(page);
        page.End().NewLine();
        WriteFigure(
            page,
            "Lateral error",
            "Distance from the lane centre, positive to the right, while the controller drives outside junctions. It jumps at a lane "
                + "change. "
                + "Dashed: where the side of the car reaches the marking of a lane 5.4 m wide.",
            plots.LateralError()
        );
        WriteFigure(page, "Speed", "", plots.Speed());
        WriteFigure(page, "Jerk", "Rate of change of the acceleration along the car, while the controller drives.", plots.Jerk());
        WriteFigure(page, "Progress", "", plots.Progress());

        IEnumerable<DriveEvent> EventsIn(IEnumerable<DriveEvent> events) => events.Where(each => each.Episode == episode);
    }

    private static void WriteFigure(MarkupWriter page, string caption, string hint, LinePlot plot)
    {
        StartFigure(page, caption);
        if (hint.Length > 0)
        {
            page.Start("p").With("class", "hint").Text(hint).End().NewLine();
        }

        plot.Write(page);
        page.End().NewLine();
    }

    private static void StartFigure(MarkupWriter page, string caption) => page.Start("figure").Element("figcaption", caption).NewLine();

    private static MarkupWriter WriteKey(MarkupWriter page, string style, string text) =>
        page.Start("b").With("class", style).Text(text).End();
}
