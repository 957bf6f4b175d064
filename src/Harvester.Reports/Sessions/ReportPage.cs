using System.Text;
using Harvester.Pages;

namespace Harvester.Reports.Sessions;

/// <summary>The page that shows a session, of a report or of a viewer: markup, style and scripts without data.</summary>
internal static class ReportPage
{
    /// <summary>The parts of the report's script, in the order in which they use each other.</summary>
    public static IReadOnlyList<string> ScriptsOfReport { get; } = ["page.js", "state.js", "embedded.js", .. Common];

    /// <summary>The parts of the viewer's script, in the order in which they use each other.</summary>
    public static IReadOnlyList<string> ScriptsOfViewer { get; } = ["page.js", "state.js", "served.js", .. Common];

    /// <summary>The style sheet, in addition to that of all pages.</summary>
    public static string Style => Asset("report.css") + Asset("predictions.css");

    private static string[] Common =>
        [
            "matches.js",
            "rasters.js",
            "picture.js",
            "ground.js",
            "timeline.js",
            "strips.js",
            "objects.js",
            "predictions.js",
            "statistics.js",
            "report.js",
        ];

    /// <summary>Writes the page.</summary>
    /// <param name="stream">Receives it.</param>
    /// <param name="title">Title of the browser's tab.</param>
    /// <param name="scripts">The parts of the script.</param>
    /// <param name="writeData">Writes the data that the scripts read.</param>
    /// <param name="isServed">Whether a server sends the page.</param>
    public static void Write(
        Stream stream,
        string title,
        IReadOnlyList<string> scripts,
        Action<MarkupWriter> writeData,
        bool isServed = false
    ) =>
        HtmlPage.Write(
            stream,
            title,
            Style,
            page =>
            {
                page.Markup(Asset("report.html"));
                writeData(page);
                page.Code("script", Code(scripts));
            },
            isServed
        );

    /// <summary>The script.</summary>
    public static string Code(IReadOnlyList<string> scripts) => string.Join('\n', scripts.Select(Asset));

    private static string Asset(string name)
    {
        using Stream stream = typeof(ReportPage).Assembly.GetManifestResourceStream($"Harvester.Reports.Assets.{name}")!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd().ReplaceLineEndings("\n");
    }
}
