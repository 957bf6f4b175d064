using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Statistics;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Reports;

/// <summary>The data of a report's page, as report.js reads it. Numbers are rounded: the page is for eyes.</summary>
internal static class ReportData
{
    private const int Digits = 2;

    public static byte[] Write(string title, SessionInfo info, SessionStatistics statistics, IReadOnlyList<FrameLabel> frames)
    {
        using var stream = new MemoryStream();
        // The writer's usual encoder escapes < and &, so that no name can end the script element.
        using (var json = new Utf8JsonWriter(stream))
        {
            json.WriteStartObject();
            json.WriteString("title", title);
            json.WriteNumber("width", info.Image.Width);
            json.WriteNumber("height", info.Image.Height);
            WriteFacts(json, info, statistics);
            json.WriteString("note", Note(statistics.Frames, frames.Count));
            WriteClasses(json, statistics);
            WriteHistogram(json, "distances", statistics.Distances, "m", 1);
            WriteHistogram(json, "occlusions", statistics.OccludedFractions, "%", 100);
            json.WriteStartArray("frames");
            foreach (FrameLabel frame in frames)
            {
                WriteFrame(json, frame);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        return stream.ToArray();
    }

    private static string Note(int all, int shown) =>
        shown == all
            ? string.Create(CultureInfo.InvariantCulture, $"All {all} frames of the session are in this page.")
            : string.Create(
                CultureInfo.InvariantCulture, $"This page shows {shown} of the session's {all} frames, evenly chosen; its figures are of all of them.");

    private static void WriteFacts(Utf8JsonWriter json, SessionInfo info, SessionStatistics statistics)
    {
        json.WriteStartObject("facts");
        json.WriteString("Frames", statistics.Frames.ToString(CultureInfo.InvariantCulture));
        json.WriteString("Labels", statistics.Labels.ToString(CultureInfo.InvariantCulture));
        json.WriteString("Image", $"{info.Image.Width} × {info.Image.Height}");
        json.WriteString("Length", string.Create(
            CultureInfo.InvariantCulture, $"{statistics.LastTimeSeconds - statistics.FirstTimeSeconds:0.0} s"));
        json.WriteString("Weather", string.Join(", ", statistics.Weathers));
        if (info.Seed is { } seed)
        {
            json.WriteString("Seed", seed.ToString(CultureInfo.InvariantCulture));
        }

        json.WriteEndObject();
    }

    private static void WriteClasses(Utf8JsonWriter json, SessionStatistics statistics)
    {
        json.WriteStartObject("classes");
        foreach ((ObjectClass kind, ClassStatistics figures) in statistics.Classes)
        {
            json.WriteStartObject(JsonName.Of(kind));
            json.WriteString("colour", $"#{ClassColours.Of(kind):x6}");
            json.WriteNumber("labels", figures.Labels);
            json.WriteNumber("objects", figures.Objects);
            WriteNumber(json, "nearest", figures.NearestMetres);
            WriteNumber(json, "medianDistance", figures.MedianDistanceMetres);
            WriteNumber(json, "meanOcclusion", figures.MeanOccludedFraction);
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    private static void WriteHistogram(Utf8JsonWriter json, string name, Histogram histogram, string unit, double factor)
    {
        json.WriteStartObject(name);
        json.WriteString("unit", unit);
        WriteNumbers(json, "counts", histogram.Counts.Select(count => (double)count));
        WriteNumbers(json, "edges", Enumerable.Range(0, histogram.Counts.Count + 1).Select(i => i * histogram.BinWidth * factor));
        json.WriteEndObject();
    }

    private static void WriteFrame(Utf8JsonWriter json, FrameLabel frame)
    {
        Camera camera = LabelCamera.Of(frame.Camera);
        json.WriteStartObject();
        json.WriteNumber("frame", frame.Frame);
        WriteNumber(json, "time", frame.TimeSeconds);
        json.WriteString("weather", frame.Environment.Weather);
        json.WriteString("timeOfDay", frame.Environment.TimeOfDay.ToString(@"hh\:mm", CultureInfo.InvariantCulture));
        WriteNumber(json, "speed", frame.Ego.Velocity.Length);
        json.WriteStartObject("camera");
        Vector3D position = camera.Pose.Position;
        WriteNumbers(json, "position", [position.X, position.Y, position.Z]);
        WriteNumber(json, "heading", Angles.HeadingDegrees(camera.Pose.Axes.Forward));
        WriteNumber(json, "fov", frame.Camera.VerticalFovDegrees);
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
            WriteNumbers(json, null, [start.X, start.Y, end.X, end.Y]);
        }

        json.WriteEndArray();
        Vector3D half = item.Box3D.HalfExtents;
        WriteNumbers(json, "size", [2 * half.Y, 2 * half.X, 2 * half.Z]);
        WriteNumber(json, "truncated", item.TruncatedFraction);
        WriteNumber(json, "occluded", item.OccludedFraction);
        json.WriteString("method", JsonName.Of(item.OcclusionMethod));
        WriteNumber(json, "distance", item.DistanceMetres);
        WriteNumber(json, "speed", item.Velocity.Length);
        json.WriteEndObject();
    }

    private static void WriteBox(Utf8JsonWriter json, string name, Box2D box) =>
        WriteNumbers(json, name, [box.XMin, box.YMin, box.XMax, box.YMax]);

    private static void WriteNumber(Utf8JsonWriter json, string name, double? number)
    {
        if (number is { } value)
        {
            json.WriteNumber(name, Rounded(value));
        }
        else
        {
            json.WriteNull(name);
        }
    }

    private static void WriteNumbers(Utf8JsonWriter json, string? name, IEnumerable<double> numbers)
    {
        if (name is not null)
        {
            json.WritePropertyName(name);
        }

        json.WriteStartArray();
        foreach (double number in numbers)
        {
            json.WriteNumberValue(Rounded(number));
        }

        json.WriteEndArray();
    }

    // Adding 0 turns minus zero into zero.
    private static double Rounded(double value) => Math.Round(value, Digits) + 0.0;
}
