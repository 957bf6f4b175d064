using System.Globalization;
using System.Text.Json;
using Harvester.Datasets.Roads;
using Harvester.Exports.Formats.Lanes;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.OpenLaneV2;

/// <summary>
/// Writes OpenLane-V2: lanes, traffic elements and their topology, one file per frame for each of its two tasks. See
/// docs/exports/openlane-v2.md.
/// </summary>
internal sealed class OpenLaneV2Writer(ExportOptions options) : IDatasetWriter
{
    /// <summary>The list of the frames of all splits, in the root folder: the readers take every JSON file there for one.</summary>
    public const string Index = "data_dict_gta.json";

    /// <summary>The name of a single camera: the readers show traffic elements in the camera of this name alone.</summary>
    public const string FrontCamera = "ring_front_center";

    private const string ListPrefix = "list ";
    private const int Metres = 4;
    private const int Pixels = 3;
    private const int Axis = 9;

    /// <summary>The first of January 2020, nanoseconds: a fixed time, because sessions have none.</summary>
    private const long Start = 1_577_836_800_000_000_000;

    private const double Microseconds = 1e6;

    /// <summary>Nanoseconds in a microsecond; the digits below it distinguish frames of the same time.</summary>
    private const int Distinct = 1000;

    /// <summary>Greatest distance of a camera from the car, metres; no vehicle is as long.</summary>
    private const double MaxReach = 1000;

    private (SessionReader Session, LaneMaps Maps)? _maps;

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string segment = frame.SequenceIndex.ToString("D5", CultureInfo.InvariantCulture);
        long timestamp = Start + ((long)Math.Round(frame.Label.TimeSeconds * Microseconds) * Distinct) + (frame.FrameInSequence % Distinct);
        string name = timestamp.ToString(CultureInfo.InvariantCulture);
        string camera = frame.Label.View ?? FrontCamera;
        string folder = $"{frame.Split}/{segment}";
        string image = $"{folder}/image/{camera}/{name}{frame.ImageExtension}";
        Pose vehicle = VehicleFrame.Of(frame.Label.Ego);
        if (!((frame.Label.Camera.Pose.Position - vehicle.Position).Length <= MaxReach))
        {
            throw frame.Problem(FormattableString.Invariant($"its camera is more than {MaxReach} m from its car."));
        }

        LaneNetwork map =
            MapsOf(frame).Around(frame.Label.Ego.Position) ?? throw frame.Problem("more roads meet around it than a map of lanes takes.");
        ClippedLane[] lanes = [.. map.Lanes.SelectMany(lane => ClippedLane.Of(lane, vehicle))];
        TrafficElement[] elements = [.. TrafficElement.Of(frame.Label)];
        output.Image(image, frame);
        output.Text($"{folder}/info/{name}.json", Text(json => WriteCentreLines(json, lanes, elements)));
        output.Text($"{folder}/info/{name}-ls.json", Text(json => WriteSegments(json, lanes, elements, map, frame.Label, vehicle)));
        output.Part($"{ListPrefix}{folder}", $"\"{name}.json\"");
        return default;

        string Text(Action<Utf8JsonWriter> annotation) =>
            JsonLine.Of(json =>
            {
                json.WriteStartObject();
                json.WriteString("version", "v2.1");
                json.WriteString("segment_id", segment);
                json.WriteStartObject("meta_data");
                json.WriteString("source", "GtaDataHarvester");
                json.WriteString("source_id", Path.GetFileName(Path.TrimEndingDirectorySeparator(frame.Session.Folder)));
                json.WriteEndObject();
                json.WriteNumber("timestamp", timestamp);
                json.WriteStartObject("sensor");
                json.WriteStartObject(camera);
                json.WriteString("image_path", image);
                WriteCamera(json, frame.Label.Camera, vehicle);
                json.WriteEndObject();
                json.WriteEndObject();
                WritePose(json, vehicle);
                json.WriteStartObject("annotation");
                annotation(json);
                json.WriteEndObject();
                json.WriteEndObject();
            }) + "\n";
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts)
    {
        var sections = new List<AggregateSection>();
        string? split = null;
        foreach (string part in parts.Keys)
        {
            string[] path = part[ListPrefix.Length..].Split('/');
            sections.Add(
                AggregateSection.Literal(
                    split is null ? $"{{{JsonSerializer.Serialize(path[0])}: {{\n"
                    : split == path[0] ? "],\n"
                    : $"]}},\n{JsonSerializer.Serialize(path[0])}: {{\n"
                )
            );
            split = path[0];
            sections.Add(AggregateSection.Literal($"\"{path[1]}\": ["));
            sections.Add(AggregateSection.Joined(part, ", "));
        }

        sections.Add(AggregateSection.Literal(split is null ? "{}\n" : "]}}\n"));
        return [new AggregateFile(Index, sections)];
    }

    private static void WriteCentreLines(Utf8JsonWriter json, ClippedLane[] lanes, TrafficElement[] elements)
    {
        json.WriteStartArray("lane_centerline");
        foreach (ClippedLane lane in lanes)
        {
            json.WriteStartObject();
            json.WriteNumber("id", lane.Id);
            json.WriteString("name", lane.Lane.Id);
            WritePoints(json, "points", lane.Centre);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        WriteElements(json, elements);
        WriteTopology(json, "topology_lclc", lanes, lanes, static (from, to) => from.LeadsTo(to));
        WriteTopology(json, "topology_lcte", lanes, elements, static (lane, element) => element.Lanes.Contains(lane.Lane.Id));
    }

    private static void WriteSegments(
        Utf8JsonWriter json,
        ClippedLane[] lanes,
        TrafficElement[] elements,
        LaneNetwork map,
        FrameLabel label,
        Pose vehicle
    )
    {
        var painted = new PaintedEdges(label.Lanes?.Markings ?? [], vehicle);
        Dictionary<MapLane, (int Left, int Right)> numbers = EdgeNumbers.Of(label.Lanes?.LaneId is { } id ? map.Find(id) : null);
        json.WriteStartArray("lane_segment");
        foreach (ClippedLane lane in lanes)
        {
            bool isWay = lane.Lane.Junction is not null;
            (int Left, int Right)? number = numbers.TryGetValue(lane.Lane, out (int, int) known) ? known : null;
            json.WriteStartObject();
            json.WriteNumber("id", lane.Id);
            json.WriteString("name", lane.Lane.Id);
            WritePoints(json, "centerline", lane.Centre);
            WritePoints(json, "left_laneline", lane.Left);
            json.WriteNumber("left_laneline_type", isWay ? PaintedEdges.None : painted.KindOf(lane.Left, number?.Left));
            WritePoints(json, "right_laneline", lane.Right);
            json.WriteNumber("right_laneline_type", isWay ? PaintedEdges.None : painted.KindOf(lane.Right, number?.Right));
            json.WriteBoolean("is_intersection_or_connector", isWay);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        WriteElements(json, elements);
        json.WriteStartArray("area");
        foreach ((int index, (int category, IReadOnlyList<Vector3D> points)) in MapAreas.Of(map, vehicle).Index())
        {
            json.WriteStartObject();
            json.WriteNumber("id", index);
            json.WriteNumber("category", category);
            WritePoints(json, "points", points);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        WriteTopology(json, "topology_lsls", lanes, lanes, static (from, to) => from.LeadsTo(to));
        WriteTopology(json, "topology_lste", lanes, elements, static (lane, element) => element.Lanes.Contains(lane.Lane.Id));
    }

    private static void WriteElements(Utf8JsonWriter json, TrafficElement[] elements)
    {
        json.WriteStartArray("traffic_element");
        foreach (TrafficElement element in elements)
        {
            json.WriteStartObject();
            json.WriteNumber("id", element.Id);
            json.WriteNumber("category", element.Category);
            json.WriteNumber("attribute", element.Attribute);
            json.WriteStartArray("points");
            json.Values([element.Box.XMin, element.Box.YMin], Pixels);
            json.Values([element.Box.XMax, element.Box.YMax], Pixels);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteTopology<TRow, TColumn>(
        Utf8JsonWriter json,
        string name,
        TRow[] rows,
        TColumn[] columns,
        Func<TRow, TColumn, bool> isConnected
    )
    {
        json.WriteStartArray(name);
        foreach (TRow row in rows)
        {
            json.Values([.. columns.Select(column => isConnected(row, column) ? 1.0 : 0)], 0);
        }

        json.WriteEndArray();
    }

    private static void WritePoints(Utf8JsonWriter json, string name, IReadOnlyList<Vector3D> points)
    {
        json.WriteStartArray(name);
        foreach (Vector3D point in points)
        {
            json.Values([point.X, point.Y, point.Z], Metres);
        }

        json.WriteEndArray();
    }

    /// <summary>The camera in the vehicle's frame; its own has x right, y down, z forward.</summary>
    private static void WriteCamera(Utf8JsonWriter json, CameraLabel camera, Pose vehicle)
    {
        Vector3D[] axes = VehicleRange.Points(
            [
                vehicle.Position + camera.Pose.Axes.Right,
                vehicle.Position - camera.Pose.Axes.Up,
                vehicle.Position + camera.Pose.Axes.Forward,
            ],
            vehicle
        );
        json.WriteStartObject("extrinsic");
        WriteRotation(json, axes);
        Vector3D place = VehicleRange.Points([camera.Pose.Position], vehicle)[0];
        json.Numbers("translation", [place.X, place.Y, place.Z], Metres);
        json.WriteEndObject();
        json.WriteStartObject("intrinsic");
        json.WriteStartArray("K");
        json.Values([camera.Fx, 0, camera.Cx], Axis);
        json.Values([0, camera.Fy, camera.Cy], Axis);
        json.Values([0, 0, 1], Axis);
        json.WriteEndArray();
        json.Numbers("distortion", [0, 0, 0], 0);
        json.WriteEndObject();
    }

    private static void WritePose(Utf8JsonWriter json, Pose vehicle)
    {
        json.WriteStartObject("pose");
        WriteRotation(json, [vehicle.Axes.Forward, -vehicle.Axes.Right, vehicle.Axes.Up]);
        json.Numbers("translation", [vehicle.Position.X, vehicle.Position.Y, vehicle.Position.Z], Metres);
        json.WriteEndObject();
    }

    /// <summary>The rotation whose columns are three axes.</summary>
    private static void WriteRotation(Utf8JsonWriter json, Vector3D[] axes)
    {
        json.WriteStartArray("rotation");
        json.Values([axes[0].X, axes[1].X, axes[2].X], Axis);
        json.Values([axes[0].Y, axes[1].Y, axes[2].Y], Axis);
        json.Values([axes[0].Z, axes[1].Z, axes[2].Z], Axis);
        json.WriteEndArray();
    }

    private LaneMaps MapsOf(ExportFrame frame)
    {
        if (_maps is not { } known || known.Session != frame.Session)
        {
            LaneMaps maps = SessionLanes.Of(frame.Session, options.Roads) ?? throw frame.Problem($"its session has no {FramePaths.Roads}.");
            _maps = known = (frame.Session, maps);
        }

        return known.Maps;
    }
}
