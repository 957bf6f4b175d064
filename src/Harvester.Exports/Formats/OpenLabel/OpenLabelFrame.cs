using System.Globalization;
using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.OpenLabel;

/// <summary>Writes a frame of a file: where the car and the camera are, and what is seen.</summary>
internal static class OpenLabelFrame
{
    private const int Pixels = 3;
    private const int Metres = 4;
    private const int Unit = 9;
    private const int Seconds = 6;
    private const int Fractions = 5;

    /// <summary>The type of an object.</summary>
    public static string TypeOf(ExportObject item) => item.Class.Name;

    /// <summary>The text of a frame.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="image">Path of its image.</param>
    public static string Text(ExportFrame frame, string image) =>
        JsonLine.Of(json =>
        {
            FrameLabel label = frame.Label;
            json.WriteStartObject();
            WriteProperties(json, label, image);
            json.WriteStartObject("contexts");
            json.WriteStartObject("0");
            json.WriteStartObject("context_data");
            WriteTexts(
                json,
                ("weather", label.Environment.Weather),
                ("timeOfDay", label.Environment.TimeOfDay.ToString(@"hh\:mm\:ss", CultureInfo.InvariantCulture))
            );
            json.WriteEndObject();
            json.WriteEndObject();
            json.WriteEndObject();
            json.WriteStartObject("objects");
            foreach (ExportObject item in frame.Objects)
            {
                WriteObject(json, item);
            }

            WriteLanes(json, label.Lanes?.Lines ?? []);
            WriteIgnored(json, frame.Ignored);
            json.WriteEndObject();
            WriteActions(json, label.Events ?? []);
            json.WriteEndObject();
        });

    /// <summary>The open events, as actions that the frame has; nothing without one.</summary>
    private static void WriteActions(Utf8JsonWriter json, IReadOnlyList<EventMark> marks)
    {
        if (marks.Count == 0)
        {
            return;
        }

        json.WriteStartObject("actions");
        foreach (EventMark mark in marks)
        {
            json.WriteStartObject(Numbers.Text(mark.Id));
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    private static void WriteProperties(Utf8JsonWriter json, FrameLabel label, string image)
    {
        Axes ego = label.Ego.Axes ?? Axes.FromHeading(label.Ego.HeadingDegrees);
        json.WriteStartObject("frame_properties");
        json.Number("timestamp", label.TimeSeconds, Seconds);
        json.WriteStartObject("streams");
        json.WriteStartObject(OpenLabelStream.Camera);
        json.WriteString("uri", image);
        json.WriteEndObject();
        json.WriteEndObject();
        json.WriteStartObject("transforms");
        WriteTransform(json, OpenLabelStream.Ego, label.Ego.Position, Rotation.OfBody(ego));
        WriteTransform(json, OpenLabelStream.Camera, label.Camera.Pose.Position, Rotation.OfCamera(label.Camera.Pose.Axes));
        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static void WriteTransform(Utf8JsonWriter json, string from, Vector3D position, Rotation rotation)
    {
        json.WriteStartObject($"{from}_to_{OpenLabelStream.World}");
        json.WriteString("src", from);
        json.WriteString("dst", OpenLabelStream.World);
        json.WriteStartObject("transform_src_to_dst");
        json.Numbers("quaternion", [rotation.X, rotation.Y, rotation.Z, rotation.W], Unit);
        json.Numbers("translation", [position.X, position.Y, position.Z], Metres);
        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static void WriteObject(Utf8JsonWriter json, ExportObject item)
    {
        ObjectLabel label = item.Label;
        WriteData(
            json,
            label.Id,
            () =>
            {
                json.WriteStartArray("bbox");
                WriteBox(json, "box", item.Box);
                json.WriteEndArray();
                json.WriteStartArray("cuboid");
                WriteCuboid(json, label);
                json.WriteEndArray();
                json.WriteStartArray("vec");
                json.WriteStartObject();
                json.WriteString("name", "velocity");
                json.WriteString("coordinate_system", OpenLabelStream.World);
                json.Numbers("val", [label.Velocity.X, label.Velocity.Y, label.Velocity.Z], Metres);
                json.WriteEndObject();
                json.WriteEndArray();
                json.WriteStartArray("num");
                WriteNumber(json, "truncatedFraction", label.TruncatedFraction);
                WriteNumber(json, "occludedFraction", label.OccludedFraction);
                json.WriteEndArray();
                WriteTexts(
                    json,
                    ("model", label.Model),
                    ("name", label.Name),
                    ("mutcd", label.Face?.MutcdCode),
                    ("lightState", label.Face?.Light is { } light ? JsonName.Of(light.State) : null)
                );
            }
        );
    }

    /// <summary>Centre, rotation, and the size along the cuboid's own axes: forward, left, up.</summary>
    private static void WriteCuboid(Utf8JsonWriter json, ObjectLabel label)
    {
        (Vector3D centre, Vector3D half) = (label.Box3D.Centre, label.Box3D.HalfExtents);
        var rotation = Rotation.OfBody(label.Box3D.Axes);
        json.WriteStartObject();
        json.WriteString("name", "cuboid");
        json.WriteString("coordinate_system", OpenLabelStream.World);
        json.WriteStartArray("val");
        Write(Metres, centre.X, centre.Y, centre.Z);
        Write(Unit, rotation.X, rotation.Y, rotation.Z, rotation.W);
        Write(Metres, 2 * half.Y, 2 * half.X, 2 * half.Z);
        json.WriteEndArray();
        json.WriteEndObject();

        void Write(int decimals, params ReadOnlySpan<double> values)
        {
            foreach (double value in values)
            {
                json.Value(value, decimals);
            }
        }
    }

    private static void WriteLanes(Utf8JsonWriter json, IReadOnlyList<LaneLineView> lines)
    {
        if (lines.Count == 0)
        {
            return;
        }

        WriteData(
            json,
            OpenLabelWriter.LaneObject,
            () =>
            {
                json.WriteStartArray("poly2d");
                for (int i = 0; i < lines.Count; i++)
                {
                    json.WriteStartObject();
                    json.WriteString("name", $"line {i}");
                    json.WriteString("coordinate_system", OpenLabelStream.Camera);
                    json.Numbers("val", [.. lines[i].Points.SelectMany(point => new[] { point.Pixel.X, point.Pixel.Y })], Pixels);
                    json.WriteString("mode", "MODE_POLY2D_ABSOLUTE");
                    json.WriteBoolean("closed", false);
                    json.WriteStartObject("attributes");
                    json.WriteStartArray("num");
                    WriteNumber(json, "index", lines[i].Index);
                    json.WriteEndArray();
                    WriteTexts(
                        json,
                        ("style", lines[i].Paint is { } style ? JsonName.Of(style.Style) : null),
                        ("colour", lines[i].Paint is { } colour ? JsonName.Of(colour.Colour) : null)
                    );
                    json.WriteEndObject();
                    json.WriteEndObject();
                }

                json.WriteEndArray();
            }
        );
    }

    private static void WriteIgnored(Utf8JsonWriter json, IReadOnlyList<ExportRegion> regions)
    {
        if (regions.Count == 0)
        {
            return;
        }

        WriteData(
            json,
            OpenLabelWriter.IgnoreObject,
            () =>
            {
                json.WriteStartArray("bbox");
                for (int i = 0; i < regions.Count; i++)
                {
                    WriteBox(json, $"region {i}", regions[i].Box);
                }

                json.WriteEndArray();
            }
        );
    }

    private static void WriteData(Utf8JsonWriter json, int id, Action write)
    {
        json.WriteStartObject(Numbers.Text(id));
        json.WriteStartObject("object_data");
        write();
        json.WriteEndObject();
        json.WriteEndObject();
    }

    /// <summary>Centre, width and height.</summary>
    private static void WriteBox(Utf8JsonWriter json, string name, Box2D box)
    {
        json.WriteStartObject();
        json.WriteString("name", name);
        json.WriteString("coordinate_system", OpenLabelStream.Camera);
        json.Numbers("val", [(box.XMin + box.XMax) / 2, (box.YMin + box.YMax) / 2, box.Width, box.Height], Pixels);
        json.WriteEndObject();
    }

    private static void WriteNumber(Utf8JsonWriter json, string name, double? value)
    {
        if (value is { } known)
        {
            json.WriteStartObject();
            json.WriteString("name", name);
            json.Number("val", known, Fractions);
            json.WriteEndObject();
        }
    }

    private static void WriteTexts(Utf8JsonWriter json, params (string Name, string? Value)[] texts)
    {
        json.WriteStartArray("text");
        foreach ((string name, string? value) in texts)
        {
            if (value is not null)
            {
                json.WriteStartObject();
                json.WriteString("name", name);
                json.WriteString("val", value);
                json.WriteEndObject();
            }
        }

        json.WriteEndArray();
    }
}
