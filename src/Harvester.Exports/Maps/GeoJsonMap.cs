using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Maps;

/// <summary>
/// Writes a lane map as a GeoJSON feature collection: a line for the middle of each lane, with its edges and links as properties.
/// Coordinates are metres of the game's world, not degrees, so the file is GeoJSON in form only.
/// </summary>
public static class GeoJsonMap
{
    private const int Decimals = 3;

    /// <summary>Writes a map.</summary>
    /// <param name="map">The map.</param>
    /// <param name="stream">Receives the file, UTF-8, a lane a line.</param>
    public static void Write(LaneNetwork map, Stream stream)
    {
        ArgumentNullException.ThrowIfNull(map);
        ArgumentNullException.ThrowIfNull(stream);
        stream.Write("{\"type\":\"FeatureCollection\",\"features\":[\n"u8);
        for (int i = 0; i < map.Lanes.Count; i++)
        {
            stream.Write(i == 0 ? ""u8 : ",\n"u8);
            using var json = new Utf8JsonWriter(stream);
            WriteLane(json, map.Lanes[i]);
        }

        stream.Write("\n]}\n"u8);
    }

    private static void WriteLane(Utf8JsonWriter json, MapLane lane)
    {
        json.WriteStartObject();
        json.WriteString("type", "Feature");
        json.WriteString("id", lane.Id);
        json.WriteStartObject("geometry");
        json.WriteString("type", "LineString");
        WritePoints(json, "coordinates", lane.Centre);
        json.WriteEndObject();
        json.WriteStartObject("properties");
        json.WriteString("kind", lane.Junction is null ? "lane" : "way");
        if (lane.Turn is { } turn)
        {
            json.WriteString("turn", JsonName.Of(turn));
        }

        json.WriteNumber("widthMetres", Math.Round(lane.StartWidth, Decimals));
        WriteIds(json, "predecessors", lane.Predecessors);
        WriteIds(json, "successors", lane.Successors);
        WriteId(json, "left", lane.LeftNeighbour);
        WriteId(json, "right", lane.RightNeighbour);
        WriteId(json, "oncoming", lane.Oncoming);
        WritePoints(json, "leftEdge", lane.Left);
        WritePoints(json, "rightEdge", lane.Right);
        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static void WritePoints(Utf8JsonWriter json, string name, IReadOnlyList<Vector3D> points)
    {
        json.WriteStartArray(name);
        foreach (Vector3D point in points)
        {
            json.WriteStartArray();
            json.WriteNumberValue(Math.Round(point.X, Decimals));
            json.WriteNumberValue(Math.Round(point.Y, Decimals));
            json.WriteNumberValue(Math.Round(point.Z, Decimals));
            json.WriteEndArray();
        }

        json.WriteEndArray();
    }

    private static void WriteIds(Utf8JsonWriter json, string name, IEnumerable<MapLane> lanes)
    {
        json.WriteStartArray(name);
        foreach (MapLane lane in lanes)
        {
            json.WriteStringValue(lane.Id);
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
