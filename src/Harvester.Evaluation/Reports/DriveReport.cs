using System;
using System.Collections.Generic;
using System.IO;
using Harvester.Evaluation.Figures;
using Harvester.Pages;
using Harvester.Pages.Plots;

namespace Harvester.Evaluation.Reports;

/// <summary>Shows a drive as one HTML page: its figures, a map, and plots of lateral error, speed, jerk and progress.</summary>
public static class DriveReport
{
    /// <summary>Name of the file.</summary>
    public const string FileName = "report.html";

    private const string Style = """
        body { max-width: 1060px; }
        table { width: auto; } td { text-align: left; white-space: normal; } td + td { padding-left: 24px; }
        tr:first-child td { border-top: 0; }
        .panels { grid-template-columns: minmax(0, 1fr); } figure .hint { margin-bottom: 10px; }
        .controller { stroke: var(--accent); } .builtin { stroke: #9aa4ae; } .bound { stroke: #cf8a00; stroke-dasharray: 5 4; }
        .departure { stroke: #cf8a00; } .collision { stroke: #cf222e; }
        b.controller { color: var(--accent); } b.builtin { color: #7d868f; } b.departure { color: #b27700; } b.collision { color: #cf222e; }

        """;

    /// <summary>Writes the page.</summary>
    /// <param name="stream">Receives the page; stays open.</param>
    /// <param name="record">The settings of the drive and its figures.</param>
    /// <param name="samples">The drive.</param>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public static void Write(Stream stream, DriveRecord record, IReadOnlyList<DriveSample> samples)
    {
        ArgumentNullException.ThrowIfNull(record);
        ArgumentNullException.ThrowIfNull(samples);
        string title = $"Drive by {record.Settings["controller"]}";
        HtmlPage.Write(stream, title, Style, page =>
        {
            page.Start("header").NewLine().Element("h1", title).NewLine();
            WriteSettings(page, record.Settings);
            page.End().NewLine().Start("main").With("class", "panels").NewLine();
            WriteFigures(page, record.Figures);
            if (samples.Count > 1)
            {
                WritePlots(page, record, new DrivePlots(samples));
            }

            page.End().NewLine();
        });
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

    private static void WriteFigures(MarkupWriter page, DriveFigures figures)
    {
        page.Start("section").Start("table").NewLine();
        foreach ((string name, string value) in figures.Rows())
        {
            page.Start("tr").Element("td", name).Element("td", value).End().NewLine();
        }

        page.End().End().NewLine();
    }

    private static void WritePlots(MarkupWriter page, DriveRecord record, DrivePlots plots)
    {
        StartFigure(page, "Map");
        page.Start("p").With("class", "hint");
        WriteKey(page, DrivePlots.ByController, "The controller").Text(" drives where lanes are known; the ");
        WriteKey(page, DrivePlots.ByBuiltInDriver, "built-in driver")
            .Text(" drives through junctions and where it has to give way. Rings mark ");
        WriteKey(page, DrivePlots.Departure, "lane departures").Text(" and ");
        WriteKey(page, DrivePlots.Collision, "collisions").Text(".").End().NewLine();
        plots.Map(record).Write(page);
        page.End().NewLine();
        WriteFigure(
            page,
            "Lateral error",
            "Distance from the lane centre, positive to the right, while the controller drives outside junctions. It jumps at a lane "
                + "change. "
            + "Dashed: where the side of the car reaches the marking of a lane 5.4 m wide.",
            plots.LateralError());
        WriteFigure(page, "Speed", "", plots.Speed());
        WriteFigure(page, "Jerk", "Rate of change of the acceleration along the car, while the controller drives.", plots.Jerk());
        WriteFigure(page, "Progress", "", plots.Progress());
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
