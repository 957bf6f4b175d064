using System.Globalization;
using System.Text.Json;
using Harvester.Datasets.Colours;
using Harvester.Datasets.Statistics;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Sessions;

/// <summary>The data of a session's report, as the page's scripts read it. Numbers are rounded to what is visible.</summary>
internal static class ReportData
{
    private const int Decimals = 2;

    /// <summary>Writes the data as one object.</summary>
    public static void Write(
        Utf8JsonWriter json,
        string title,
        SessionInfo info,
        SessionStatistics statistics,
        IReadOnlyList<FrameLabel> frames,
        IEnumerable<DrivingEvent> events,
        double pictureScale,
        bool hasPredictions,
        bool showsPosts
    )
    {
        json.WriteStartObject();
        WriteHead(json, title, info);
        json.WriteBoolean("posts", showsPosts);
        ReportFigures.Write(json, info, statistics);
        json.WriteString(
            "note",
            string.Join(
                " ",
                [
                    Note(statistics.Frames, frames.Count, hasPredictions),
                    .. pictureScale < 1 ? [Note(pictureScale)] : Array.Empty<string>(),
                    .. info.Unchecked.Select(open => $"Note: {open}"),
                ]
            )
        );
        FrameEvents.Write(json, FrameEvents.Of(frames));
        ReportEvents.Write(json, events, frames);
        WriteObjects(json, frames.SelectMany(frame => frame.Objects));
        json.WriteStartArray("frames");
        foreach (FrameLabel frame in frames)
        {
            ReportFrame.Write(json, frame);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    /// <summary>Writes what a page needs before it knows any frame, as fields of the current object.</summary>
    public static void WriteHead(Utf8JsonWriter json, string title, SessionInfo info)
    {
        json.WriteString("title", title);
        json.WriteNumber("width", info.Image.Width);
        json.WriteNumber("height", info.Image.Height);
        json.WriteStartArray("indicatorTable");
        foreach (IndicatorDefinition indicator in IndicatorTable.All)
        {
            json.WriteStartArray();
            json.WriteStringValue(indicator.Name);
            json.WriteStringValue(indicator.Unit);
            json.WriteEndArray();
        }

        json.WriteEndArray();
        json.WriteStartObject("colours");
        foreach (ObjectClass kind in Enum.GetValues<ObjectClass>())
        {
            json.WriteString(JsonName.Of(kind), $"#{ClassColours.Of(kind):x6}");
        }

        json.WriteEndObject();
        json.WriteStartArray("views");
        foreach (RigCamera camera in info.Rig?.Cameras ?? [])
        {
            json.WriteStartObject();
            json.WriteString("name", camera.Name);
            json.Numbers("size", [camera.Image.Width, camera.Image.Height], 0);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static string Note(int all, int shown, bool hasPredictions) =>
        shown == all
            ? string.Create(CultureInfo.InvariantCulture, $"This page shows all {all} frames of the session.")
            : string.Create(CultureInfo.InvariantCulture, $"This page shows {shown} of the session's {all} frames, ")
                + (hasPredictions ? "evenly spaced or with the most errors. " : "evenly spaced. ")
                + "The statistics cover all of them.";

    private static string Note(double pictureScale) =>
        string.Create(CultureInfo.InvariantCulture, $"Images are scaled to {100 * pictureScale:0} % so that the page stays small.");

    /// <summary>What does not change from frame to frame, by the objects' numbers.</summary>
    public static void WriteObjects(Utf8JsonWriter json, IEnumerable<ObjectLabel> objects)
    {
        json.WriteStartObject("objects");
        foreach (ObjectLabel item in objects.DistinctBy(item => item.Id))
        {
            json.WriteStartObject(item.Id.ToString(CultureInfo.InvariantCulture));
            json.WriteString("class", JsonName.Of(item.Class));
            json.WriteString("model", item.Model);
            json.WriteString("name", item.Name);
            if (item.Face?.MutcdCode is { } code)
            {
                json.WriteString("mutcd", code);
            }

            if (item.Parent is { } parent)
            {
                json.WriteNumber("parent", parent);
            }

            Vector3D half = item.Box3D.HalfExtents;
            json.Numbers("size", [2 * half.Y, 2 * half.X, 2 * half.Z], Decimals);
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }
}
