using System.Globalization;
using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Sessions;

/// <summary>A frame in the data of a report, as the page's scripts read it. Numbers are rounded to what is visible.</summary>
internal static class ReportFrame
{
    /// <summary>Decimals of what is plotted: a report and the viewer, which reads single precision, show the same numbers.</summary>
    public const int PlottedDecimals = 4;

    private const int Decimals = 2;
    private const int MetreDecimals = 1;
    private const int WholePixels = 0;

    /// <summary>Writes the frame as an object.</summary>
    public static void Write(Utf8JsonWriter json, FrameLabel frame)
    {
        Camera camera = LabelCamera.Of(frame.Camera);
        json.WriteStartObject();
        json.WriteNumber("frame", frame.Frame);
        if (frame.View is not null)
        {
            json.WriteNumber("moment", frame.Moment ?? frame.Frame);
            json.WriteString("view", frame.View);
            json.Numbers("size", [frame.Camera.Width, frame.Camera.Height], 0);
        }

        json.Number("time", frame.TimeSeconds, Decimals);
        json.WriteString("weather", frame.Environment.Weather);
        json.WriteString("timeOfDay", frame.Environment.TimeOfDay.ToString(@"hh\:mm", CultureInfo.InvariantCulture));
        WriteEgo(json, frame.Ego);
        json.WriteStartObject("camera");
        Vector3D position = camera.Pose.Position;
        json.Numbers("position", [position.X, position.Y, position.Z], Decimals);
        json.Number("heading", Angles.HeadingDegrees(camera.Pose.Axes.Forward), Decimals);
        json.Number("fov", frame.Camera.VerticalFovDegrees, Decimals);
        json.WriteEndObject();
        if (frame.Lanes is { } lanes)
        {
            WriteLanes(json, lanes);
        }

        json.WriteStartArray("objects");
        foreach (ObjectLabel item in frame.Objects)
        {
            ReportObject.Write(json, item, camera, Posts.Has(item, frame));
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void WriteEgo(Utf8JsonWriter json, EgoLabel ego)
    {
        json.Number("speed", ego.Velocity.Length, PlottedDecimals);
        json.WriteStartObject("ego");
        json.Numbers("at", [ego.Position.X, ego.Position.Y], Decimals);
        json.Number("heading", ego.HeadingDegrees, Decimals);
        if (ego.Motion is { } motion)
        {
            json.Number("yawRate", motion.YawRate, PlottedDecimals);
            json.Number("acceleration", motion.Acceleration, PlottedDecimals);
            json.Number("steering", motion.Steering, PlottedDecimals);
            json.Number("throttle", motion.Throttle, PlottedDecimals);
            json.Number("brake", motion.Brake, PlottedDecimals);
            json.WriteString("manoeuvre", motion.Manoeuvre is { } manoeuvre ? JsonName.Of(manoeuvre) : null);
        }

        json.WriteEndObject();
    }

    /// <summary>The indicators in the order of their table, null where they are inactive or unknown, and the lines.</summary>
    private static void WriteLanes(Utf8JsonWriter json, LanesLabel lanes)
    {
        json.WriteString("laneStatus", JsonName.Of(lanes.Status));
        json.WriteStartArray("indicators");
        foreach (Indicator value in IndicatorTable.All.Select(indicator => indicator.Of(lanes.Indicators)))
        {
            if (value.IsValid)
            {
                json.Value(value.Value, PlottedDecimals);
            }
            else
            {
                json.WriteNullValue();
            }
        }

        json.WriteEndArray();
        json.WriteStartArray("lines");
        foreach (LaneLineView line in lanes.Markings ?? lanes.Boundaries)
        {
            WriteLine(json, line);
        }

        json.WriteEndArray();
    }

    private static void WriteLine(Utf8JsonWriter json, LaneLineView line)
    {
        json.WriteStartObject();
        json.WriteString("side", line.IsLeftOfCar ? "left" : "right");
        if (line.Paint is { } paint)
        {
            json.WriteString("style", JsonName.Of(paint.Style));
            json.WriteString("colour", JsonName.Of(paint.Colour));
        }

        json.Numbers("pixels", [.. line.Points.SelectMany(point => new[] { point.Pixel.X, point.Pixel.Y })], WholePixels);
        json.Numbers("ground", [.. line.Points.SelectMany(point => new[] { point.World.X, point.World.Y })], MetreDecimals);
        if (line.Points.Any(point => point.IsHidden == true))
        {
            json.Numbers("hidden", [.. line.Points.Select(point => point.IsHidden == true ? 1.0 : 0)], 0);
        }

        json.WriteEndObject();
    }
}
