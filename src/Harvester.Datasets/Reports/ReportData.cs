using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Harvester.Datasets.Json;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Statistics;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Reports;

/// <summary>The data of a session's report, as report.js reads it. Numbers are rounded to what is visible.</summary>
internal static class ReportData
{
    private const int Decimals = 2;
    private const int PixelDecimals = 1;

    /// <summary>Writes the data as one object.</summary>
    public static void Write(
        Utf8JsonWriter json, string title, SessionInfo info, SessionStatistics statistics, IReadOnlyList<FrameLabel> frames,
        double pictureScale)
    {
        json.WriteStartObject();
        json.WriteString("title", title);
        json.WriteNumber("width", info.Image.Width);
        json.WriteNumber("height", info.Image.Height);
        ReportFigures.Write(json, info, statistics);
        json.WriteString("note",
            string.Join(
                " ",
                [
                    Note(statistics.Frames, frames.Count), .. pictureScale < 1 ? [Note(pictureScale)] : Array.Empty<string>(),
                    .. info.Unchecked.Select(open => $"Note: {open}"),
                ]));
        WriteObjects(json, frames);
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
            : string.Create(CultureInfo.InvariantCulture, $"This page shows {shown} of the session's {all} frames, evenly spaced. ")
                + "The statistics cover all of them.";

    private static string Note(double pictureScale) =>
        string.Create(CultureInfo.InvariantCulture, $"Images are scaled to {100 * pictureScale:0} % so that the page stays small.");

    /// <summary>What does not change from frame to frame, by the objects' numbers.</summary>
    private static void WriteObjects(Utf8JsonWriter json, IEnumerable<FrameLabel> frames)
    {
        json.WriteStartObject("objects");
        foreach (ObjectLabel item in frames.SelectMany(frame => frame.Objects).DistinctBy(item => item.Id))
        {
            json.WriteStartObject(item.Id.ToString(CultureInfo.InvariantCulture));
            json.WriteString("class", JsonName.Of(item.Class));
            json.WriteString("model", item.Model);
            json.WriteString("name", item.Name);
            Vector3D half = item.Box3D.HalfExtents;
            json.Numbers("size", [2 * half.Y, 2 * half.X, 2 * half.Z], Decimals);
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    private static void WriteFrame(Utf8JsonWriter json, FrameLabel frame)
    {
        Camera camera = LabelCamera.Of(frame.Camera);
        json.WriteStartObject();
        json.WriteNumber("frame", frame.Frame);
        if (frame.View is not null)
        {
            json.WriteString("view", frame.View);
            json.Numbers("size", [frame.Camera.Width, frame.Camera.Height], 0);
        }

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
        WriteBox(json, "box", item.Box2D);
        if (item.Box2DAmodal != item.Box2D)
        {
            WriteBox(json, "amodal", item.Box2DAmodal);
        }

        WriteCuboid(json, item.Box3D, camera);
        json.Number("truncated", item.TruncatedFraction, Decimals);
        json.Number("occluded", item.OccludedFraction, Decimals);
        json.WriteString("method", JsonName.Of(item.OcclusionMethod));
        json.Number("distance", item.DistanceMetres, Decimals);
        json.Number("speed", item.Velocity.Length, Decimals);
        json.WriteEndObject();
    }

    /// <summary>The pixels of the corners, or of what the near plane leaves of the edges.</summary>
    private static void WriteCuboid(Utf8JsonWriter json, Cuboid cuboid, Camera camera)
    {
        Projection[] corners = [.. Enumerable.Range(0, Cuboid.CornerCount).Select(number => camera.Project(cuboid.Corner(number)))];
        if (corners.All(corner => corner.Outcome != ProjectionOutcome.BehindNearPlane))
        {
            json.Numbers("corners", [.. corners.SelectMany(corner => new[] { corner.U, corner.V })], PixelDecimals);
            return;
        }

        json.WriteStartArray("edges");
        foreach ((Vector2D start, Vector2D end) in CuboidEdges.Of(camera, cuboid))
        {
            json.Values([start.X, start.Y, end.X, end.Y], PixelDecimals);
        }

        json.WriteEndArray();
    }

    private static void WriteBox(Utf8JsonWriter json, string name, Box2D box) =>
        json.Numbers(name, [box.XMin, box.YMin, box.XMax, box.YMax], PixelDecimals);
}
