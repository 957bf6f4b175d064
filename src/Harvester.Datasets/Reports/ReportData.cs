using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Harvester.Datasets.Json;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Statistics;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Reports;

/// <summary>The data of a session's report as report.js reads it. Numbers are rounded to what can be seen.</summary>
internal static class ReportData
{
    private const int Decimals = 2;

    /// <summary>Writes it as one object.</summary>
    public static void Write(
        Utf8JsonWriter json, string title, SessionInfo info, SessionStatistics statistics, IReadOnlyList<FrameLabel> frames)
    {
        json.WriteStartObject();
        json.WriteString("title", title);
        json.WriteNumber("width", info.Image.Width);
        json.WriteNumber("height", info.Image.Height);
        ReportFigures.Write(json, info, statistics);
        json.WriteString("note",
            string.Join(" ", [Note(statistics.Frames, frames.Count), .. info.Unchecked.Select(open => $"Note: {open}")]));
        json.WriteStartArray("frames");
        foreach (FrameLabel frame in frames)
        {
            WriteFrame(json, frame);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static string Note(int all, int shown) =>
        shown == all
            ? string.Create(CultureInfo.InvariantCulture, $"This page shows all {all} frames of the session.")
            : string.Create(
                CultureInfo.InvariantCulture, $"This page shows {shown} of the session's {all} frames, evenly spaced. The statistics cover all of them.");

    private static void WriteFrame(Utf8JsonWriter json, FrameLabel frame)
    {
        Camera camera = LabelCamera.Of(frame.Camera);
        json.WriteStartObject();
        json.WriteNumber("frame", frame.Frame);
        json.Number("time", frame.TimeSeconds, Decimals);
        json.WriteString("weather", frame.Environment.Weather);
        json.WriteString("timeOfDay", frame.Environment.TimeOfDay.ToString(@"hh\:mm", CultureInfo.InvariantCulture));
        json.Number("speed", frame.Ego.Velocity.Length, Decimals);
        json.WriteStartObject("camera");
        Vector3D position = camera.Pose.Position;
        json.Numbers("position", [position.X, position.Y, position.Z], Decimals);
        json.Number("heading", Angles.HeadingDegrees(camera.Pose.Axes.Forward), Decimals);
        json.Number("fov", frame.Camera.VerticalFovDegrees, Decimals);
        json.WriteEndObject();
        json.WriteStartArray("objects");
        foreach (ObjectLabel item in frame.Objects)
        {
            WriteObject(json, item, camera);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void WriteObject(Utf8JsonWriter json, ObjectLabel item, Camera camera)
    {
        json.WriteStartObject();
        json.WriteNumber("id", item.Id);
        json.WriteString("class", JsonName.Of(item.Class));
        json.WriteString("model", item.Model);
        json.WriteString("name", item.Name);
        WriteBox(json, "box", item.Box2D);
        WriteBox(json, "amodal", item.Box2DAmodal);
        json.WriteStartArray("edges");
        foreach ((Vector2D start, Vector2D end) in CuboidEdges.Of(camera, item.Box3D))
        {
            json.Values([start.X, start.Y, end.X, end.Y], Decimals);
        }

        json.WriteEndArray();
        Vector3D half = item.Box3D.HalfExtents;
        json.Numbers("size", [2 * half.Y, 2 * half.X, 2 * half.Z], Decimals);
        json.Number("truncated", item.TruncatedFraction, Decimals);
        json.Number("occluded", item.OccludedFraction, Decimals);
        json.WriteString("method", JsonName.Of(item.OcclusionMethod));
        json.Number("distance", item.DistanceMetres, Decimals);
        json.Number("speed", item.Velocity.Length, Decimals);
        json.WriteEndObject();
    }

    private static void WriteBox(Utf8JsonWriter json, string name, Box2D box) =>
        json.Numbers(name, [box.XMin, box.YMin, box.XMax, box.YMax], Decimals);
}
