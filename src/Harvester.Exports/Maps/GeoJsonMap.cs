using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Maps;

/// <summary>
/// Writes a lane map as a GeoJSON feature collection: a line for the middle of each lane, with its edges, markings and links as
/// properties; then a point for each light and sign, a line for each stop line, and a polygon for each crossing.
/// Coordinates are metres of the game's world, not degrees, so the file is GeoJSON in form only.
/// </summary>
public static class GeoJsonMap
{
    private const int Decimals = 3;

    /// <summary>Writes a map.</summary>
    /// <param name="map">The map.</param>
    /// <param name="stream">Receives the file, UTF-8, a feature a line.</param>
    public static void Write(LaneNetwork map, Stream stream)
    {
        ArgumentNullException.ThrowIfNull(map);
        ArgumentNullException.ThrowIfNull(stream);
        stream.Write("{\"type\":\"FeatureCollection\",\"features\":[\n"u8);
        bool isFirst = true;
        foreach (
            Action<Utf8JsonWriter> write in map
                .Lanes.Select(lane => (Action<Utf8JsonWriter>)(json => WriteLane(json, lane)))
                .Concat(map.Signals.Select(signal => (Action<Utf8JsonWriter>)(json => WriteSignal(json, signal))))
                .Concat(map.StopLines.Select(line => (Action<Utf8JsonWriter>)(json => WriteStopLine(json, line))))
                .Concat(map.Crossings.Select(crossing => (Action<Utf8JsonWriter>)(json => WriteCrossing(json, crossing))))
        )
        {
            stream.Write(isFirst ? ""u8 : ",\n"u8);
            isFirst = false;
            using var json = new Utf8JsonWriter(stream);
            json.WriteStartObject();
            json.WriteString("type", "Feature");
            write(json);
            json.WriteEndObject();
            json.WriteEndObject();
        }

        stream.Write("\n]}\n"u8);
    }

    private static void WriteLane(Utf8JsonWriter json, MapLane lane)
    {
        Begin(json, lane.Id, "LineString", lane.Junction is null ? "lane" : "way", () => WritePoints(json, lane.Centre));
        if (lane.Turn is { } turn)
        {
            json.WriteString("turn", JsonName.Of(turn));
        }

        json.WriteNumber("widthMetres", Math.Round(lane.StartWidth, Decimals));
        if (lane.SpeedLimit is { } limit)
        {
            json.WriteNumber("speedLimitMetresPerSecond", Math.Round(limit, Decimals));
        }

        WriteIds(json, "predecessors", lane.Predecessors.Select(other => other.Id));
        WriteIds(json, "successors", lane.Successors.Select(other => other.Id));
        WriteId(json, "left", lane.LeftNeighbour);
        WriteId(json, "right", lane.RightNeighbour);
        WriteId(json, "oncoming", lane.Oncoming);
        WriteMarking(json, "leftMarking", lane.LeftMarking);
        WriteMarking(json, "rightMarking", lane.RightMarking);
        WriteIds(json, "signals", lane.Signals.Select(signal => signal.Id));
        if (lane.StopLine is { } line)
        {
            json.WriteString("stopLine", line.Id);
        }

        json.WritePropertyName("leftEdge");
        WritePoints(json, lane.Left);
        json.WritePropertyName("rightEdge");
        WritePoints(json, lane.Right);
    }

    private static void WriteSignal(Utf8JsonWriter json, MapSignal signal)
    {
        Begin(json, signal.Id, "Point", JsonName.Of(signal.Kind), () => WritePoint(json, signal.Position));
        json.WriteString("model", signal.Model);
        json.WritePropertyName("facing");
        WritePoint(json, signal.Facing);
        WriteIds(json, "lanes", signal.Lanes.Select(lane => lane.Id));
        if (signal.StopLine is { } line)
        {
            json.WriteString("stopLine", line.Id);
        }
    }

    private static void WriteStopLine(Utf8JsonWriter json, MapStopLine line)
    {
        Begin(json, line.Id, "LineString", "stopLine", () => WritePoints(json, [line.Left, line.Right]));
        json.WriteString("source", JsonName.Of(line.Source));
        WriteIds(json, "lanes", line.Lanes.Select(lane => lane.Id));
    }

    private static void WriteCrossing(Utf8JsonWriter json, MapCrossing crossing)
    {
        Begin(
            json,
            crossing.Id,
            "Polygon",
            "crossing",
            () =>
            {
                json.WriteStartArray();
                WritePoints(json, [.. crossing.Corners, crossing.Corners[0]]);
                json.WriteEndArray();
            }
        );
        json.WriteString("source", JsonName.Of(crossing.Source));
    }

    /// <summary>Writes a feature up to its kind, the first of its properties.</summary>
    private static void Begin(Utf8JsonWriter json, string id, string geometry, string kind, Action writeCoordinates)
    {
        json.WriteString("id", id);
        json.WriteStartObject("geometry");
        json.WriteString("type", geometry);
        json.WritePropertyName("coordinates");
        writeCoordinates();
        json.WriteEndObject();
        json.WriteStartObject("properties");
        json.WriteString("kind", kind);
    }

    private static void WriteMarking(Utf8JsonWriter json, string name, MapMarking? marking)
    {
        if (marking is null)
        {
            return;
        }

        json.WriteStartObject(name);
        json.WriteString("style", JsonName.Of(marking.Paint.Style));
        json.WriteString("colour", JsonName.Of(marking.Paint.Colour));
        json.WriteNumber("widthMetres", Math.Round(marking.Paint.WidthMetres, Decimals));
        json.WriteString("source", JsonName.Of(marking.Source));
        json.WriteEndObject();
    }

    private static void WritePoints(Utf8JsonWriter json, IReadOnlyList<Vector3D> points)
    {
        json.WriteStartArray();
        foreach (Vector3D point in points)
        {
            WritePoint(json, point);
        }

        json.WriteEndArray();
    }

    private static void WritePoint(Utf8JsonWriter json, Vector3D point)
    {
        json.WriteStartArray();
        json.WriteNumberValue(Math.Round(point.X, Decimals));
        json.WriteNumberValue(Math.Round(point.Y, Decimals));
        json.WriteNumberValue(Math.Round(point.Z, Decimals));
        json.WriteEndArray();
    }

    private static void WriteIds(Utf8JsonWriter json, string name, IEnumerable<string> ids)
    {
        json.WriteStartArray(name);
        foreach (string id in ids)
        {
            json.WriteStringValue(id);
        }

        json.WriteEndArray();
    }

    private static void WriteId(Utf8JsonWriter json, string name, MapLane? lane)
    {
        if (lane is null)
        {
            json.WriteNull(name);
        }
        else
        {
            json.WriteString(name, lane.Id);
        }
    }
}
