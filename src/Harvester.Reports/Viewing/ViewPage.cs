using System.Text.Json;
using Harvester.Pages;
using Harvester.Reports.Sessions;

namespace Harvester.Reports.Viewing;

/// <summary>The page of a served session: that of a report, whose frames come from the server.</summary>
internal static class ViewPage
{
    /// <summary>Writes the page.</summary>
    /// <returns>Its content security policy.</returns>
    public static string Write(Stream stream, SessionView view)
    {
        IReadOnlyList<string> scripts = ReportPage.ScriptsOfViewer;
        ReportPage.Write(
            stream,
            $"{view.Name}: session",
            scripts,
            page => page.Json("data", json => WriteData(json, view)),
            isServed: true
        );
        return PagePolicy.Of(ReportPage.Style, ReportPage.Code(scripts));
    }

    private static void WriteData(Utf8JsonWriter json, SessionView view)
    {
        json.WriteStartObject();
        json.WriteBoolean("isServed", true);
        ReportData.WriteHead(json, view.Name, view.Info);
        json.WriteNumber("count", view.Frames);
        json.WriteNumber("blockFrames", OverviewBlock.Frames);
        json.WriteString("note", string.Join(" ", view.Info.Unchecked.Select(open => $"Note: {open}")));
        json.WriteStartObject("objects");
        json.WriteEndObject();
        json.WriteStartArray("frames");
        json.WriteEndArray();
        json.WriteEndObject();
    }
}
