using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>Writes OpenLane: 3D lane lines, one JSON file per frame. See docs/exports/openlane.md.</summary>
internal sealed class OpenLaneWriter : IDatasetWriter
{
    private const int Metres = 4;
    private const int Pixels = 3;
    private const int Axis = 9;
    private const int UnknownCategory = 0;
    private const string ListPrefix = "list ";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        if (frame.Label.Lanes is not { Status: LaneStatus.Known } lanes)
        {
            return default;
        }

        string path = $"{frame.Split}/segment-{frame.SequenceIndex:D4}/{frame.FrameInSequence:D8}";
        string image = path + frame.ImageExtension;
        output.Image("images/" + image, frame);
        output.Text($"lane3d/{path}.json", Text(frame, lanes, image) + "\n");
        output.Part(ListPrefix + frame.Split, image);
        return default;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts.Keys.Select(part => new AggregateFile($"{part[ListPrefix.Length..]}.txt", [AggregateSection.Lines(part)]));

    private static string Text(ExportFrame frame, LanesLabel lanes, string image) =>
        JsonLine.Of(json =>
        {
            CameraLabel camera = frame.Label.Camera;
            json.WriteStartObject();
            WriteMatrix(json, "extrinsic", 4, Extrinsic(frame.Label));
            WriteMatrix(json, "intrinsic", 3, [camera.Fx, 0, camera.Cx, 0, camera.Fy, camera.Cy, 0, 0, 1]);
            json.WriteString("file_path", image);
            json.WriteStartArray("lane_lines");
            IReadOnlyDictionary<int, int> attributes = LanePlaces.Of(lanes.Lines);
            foreach (LaneLineView view in WholeLines.Of(lanes.Lines, frame.Image))
            {
                WriteLine(json, view, attributes[view.Index]);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        });

    private static void WriteLine(Utf8JsonWriter json, LaneLineView view, int attribute)
    {
        json.WriteStartObject();
        json.WriteNumber("category", CategoryOf(view.Paint));

        // In the dataset, lines continue behind vehicles; only points beyond the end of a line in the image are invisible.
        json.Numbers("visibility", [.. view.Points.Select(_ => 1.0)], 0);
        json.WriteStartArray("uv");
        WriteRow(json, view.Points.Select(point => point.Pixel.X), Pixels);
        WriteRow(json, view.Points.Select(point => point.Pixel.Y), Pixels);
        json.WriteEndArray();

        // In the format, the camera has x forward, y left and z up.
        json.WriteStartArray("xyz");
        WriteRow(json, view.Points.Select(point => point.InCamera.Y), Metres);
        WriteRow(json, view.Points.Select(point => -point.InCamera.X), Metres);
        WriteRow(json, view.Points.Select(point => point.InCamera.Z), Metres);
        json.WriteEndArray();
        json.WriteNumber("attribute", attribute);
        json.WriteNumber("track_id", view.Index);
        json.WriteEndObject();
    }

    /// <summary>The dataset's categories of white and yellow lines; 0 if it is not known that the boundary is painted.</summary>
    private static int CategoryOf(MarkingPaint? paint) =>
        paint is { } known
            ? (known.Colour, known.Style) switch
            {
                (MarkingColour.White, MarkingStyle.Dashed) => 1,
                (MarkingColour.White, MarkingStyle.Solid) => 2,
                (MarkingColour.White, MarkingStyle.DoubleSolid) => 4,
                (MarkingColour.Yellow, MarkingStyle.Dashed) => 7,
                (MarkingColour.Yellow, MarkingStyle.Solid) => 8,
                (MarkingColour.Yellow, MarkingStyle.DoubleSolid) => 10,
                _ => UnknownCategory,
            }
            : UnknownCategory;

    /// <summary>The matrix, by rows, from the camera's frame to the vehicle's (both x forward, y left, z up).</summary>
    private static double[] Extrinsic(FrameLabel label)
    {
        Pose vehicle = VehicleFrame.Of(label.Ego);
        Axes camera = label.Camera.Pose.Axes;
        Vector3D forward = vehicle.Axes.ToLocal(camera.Forward);
        Vector3D right = vehicle.Axes.ToLocal(camera.Right);
        Vector3D up = vehicle.Axes.ToLocal(camera.Up);
        Vector3D position = vehicle.ToLocal(label.Camera.Pose.Position);
        return
        [
            forward.Y,
            -right.Y,
            up.Y,
            position.Y,
            -forward.X,
            right.X,
            -up.X,
            -position.X,
            forward.Z,
            -right.Z,
            up.Z,
            position.Z,
            0,
            0,
            0,
            1,
        ];
    }

    private static void WriteMatrix(Utf8JsonWriter json, string name, int columns, double[] values)
    {
        json.WriteStartArray(name);
        foreach (double[] row in values.Chunk(columns))
        {
            WriteRow(json, row, Axis);
        }

        json.WriteEndArray();
    }

    private static void WriteRow(Utf8JsonWriter json, IEnumerable<double> values, int decimals)
    {
        json.WriteStartArray();
        foreach (double value in values)
        {
            json.Value(value, decimals);
        }

        json.WriteEndArray();
    }
}
