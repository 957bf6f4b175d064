using System.Text.Encodings.Web;
using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Maps;

/// <summary>
/// Writes a lane map as the JSON of an Argoverse 2 vector map (log_map_archive). Metres of the game's world. Lanes are numbered from 1;
/// the field name has the name of the lane, which Argoverse 2 does not have.
/// </summary>
public sealed class ArgoverseMap
{
    /// <summary>What is written is held in memory up to this, bytes.</summary>
    private const int MaxPending = 1 << 20;

    private const int Decimals = 3;
    private readonly LaneNetwork _map;
    private readonly LaneBorders _borders;
    private readonly MapLane[] _lanes;
    private readonly Dictionary<MapLane, int> _numbers = [];
    private readonly Utf8JsonWriter _json;

    private ArgoverseMap(LaneNetwork map, Utf8JsonWriter json)
    {
        (_map, _json) = (map, json);
        _borders = new LaneBorders(map);
        _lanes = [.. map.Lanes.Where(lane => !_borders.LeftOut.Contains(lane))];
        foreach (MapLane lane in _lanes)
        {
            _numbers.Add(lane, _numbers.Count + 1);
        }
    }

    /// <summary>Writes a map.</summary>
    /// <param name="map">The map.</param>
    /// <param name="stream">Receives the file, UTF-8.</param>
    public static void Write(LaneNetwork map, Stream stream)
    {
        ArgumentNullException.ThrowIfNull(map);
        ArgumentNullException.ThrowIfNull(stream);
        using var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping });
        new ArgoverseMap(map, json).Write();
    }

    private void Write()
    {
        _json.WriteStartObject();
        WriteNumbered("pedestrian_crossings", [.. _map.Crossings.Where(crossing => crossing.Corners.Count == 4)], WriteCrossing);
        WriteNumbered("lane_segments", _lanes, WriteLane);
        WriteNumbered("drivable_areas", [.. AreasOf()], area => WritePoints("area_boundary", area));
        _json.WriteEndObject();
    }

    private void WriteNumbered<T>(string name, T[] items, Action<T> writeFields)
    {
        _json.WriteStartObject(name);
        for (int i = 0; i < items.Length; i++)
        {
            _json.WriteStartObject(Numbers.Text(i + 1));
            _json.WriteNumber("id", i + 1);
            writeFields(items[i]);
            _json.WriteEndObject();
            if (_json.BytesPending > MaxPending)
            {
                _json.Flush();
            }
        }

        _json.WriteEndObject();
    }

    private void WriteLane(MapLane lane)
    {
        bool isWay = lane.Junction is not null;
        (BorderSide left, BorderSide right) = (_borders.LeftOf(lane), _borders.RightOf(lane));
        _json.WriteString("name", lane.Id);
        _json.WriteBoolean("is_intersection", isWay);
        _json.WriteString("lane_type", "VEHICLE");
        WritePoints("left_lane_boundary", left.Nodes.Select(node => _borders.Nodes[node]));
        _json.WriteString("left_lane_mark_type", TypeOf(left.Border, isWay));
        WritePoints("right_lane_boundary", right.Nodes.Select(node => _borders.Nodes[node]));
        _json.WriteString("right_lane_mark_type", TypeOf(right.Border, isWay));
        WriteNumbers("successors", _borders.After(lane));
        WriteNumbers("predecessors", _borders.Before(lane));
        WriteNumber("left_neighbor_id", lane.LeftNeighbour);
        WriteNumber("right_neighbor_id", lane.RightNeighbour);
    }

    private static string TypeOf(LaneBorder border, bool isWay)
    {
        if (border.Marking is not { Paint: var paint })
        {
            return isWay ? "NONE" : "UNKNOWN";
        }

        string style = paint.Style switch
        {
            MarkingStyle.Dashed => "DASHED",
            MarkingStyle.DoubleSolid => "DOUBLE_SOLID",
            _ => "SOLID",
        };
        return $"{style}_{JsonName.Of(paint.Colour).ToUpperInvariant()}";
    }

    /// <summary>Roads from edge to edge, and the ways through junctions.</summary>
    private IEnumerable<IEnumerable<Vector3D>> AreasOf()
    {
        foreach (RoadSegment road in _map.Segments)
        {
            MapLane[][] sides = [.. new[] { road.Forward, road.Backward }.Where(side => side.Count > 0).Select(side => side.ToArray())];
            if (sides.Length > 0)
            {
                yield return Outline(
                    _borders.RightOf(sides[0][^1]),
                    sides.Length > 1 ? _borders.RightOf(sides[1][^1]).Nodes : Back(sides[0][0])
                );
            }
        }

        foreach (MapLane way in _lanes.Where(lane => lane.Junction is not null))
        {
            yield return Outline(_borders.RightOf(way), Back(way));
        }
    }

    private IEnumerable<int> Back(MapLane lane) => _borders.LeftOf(lane).Nodes.Reverse();

    private IEnumerable<Vector3D> Outline(BorderSide right, IEnumerable<int> back) =>
        right.Nodes.Concat(back).Select(node => _borders.Nodes[node]);

    /// <summary>The two edges along which people walk: the longer sides.</summary>
    private void WriteCrossing(MapCrossing crossing)
    {
        IReadOnlyList<Vector3D> corners = crossing.Corners;
        double SideOf(int corner) => (corners[(corner + 1) % 4] - corners[corner]).Length;
        int first = SideOf(0) + SideOf(2) >= SideOf(1) + SideOf(3) ? 0 : 1;
        _json.WriteString("name", crossing.Id);
        WritePoints("edge1", [corners[first], corners[first + 1]]);
        WritePoints("edge2", [corners[(first + 3) % 4], corners[first + 2]]);
    }

    private void WritePoints(string name, IEnumerable<Vector3D> points)
    {
        _json.WriteStartArray(name);
        foreach (Vector3D point in points)
        {
            _json.WriteStartObject();
            _json.WriteNumber("x", Math.Round(point.X, Decimals));
            _json.WriteNumber("y", Math.Round(point.Y, Decimals));
            _json.WriteNumber("z", Math.Round(point.Z, Decimals));
            _json.WriteEndObject();
        }

        _json.WriteEndArray();
    }

    private void WriteNumbers(string name, IEnumerable<MapLane> lanes)
    {
        _json.WriteStartArray(name);
        foreach (MapLane lane in lanes)
        {
            _json.WriteNumberValue(_numbers[lane]);
        }

        _json.WriteEndArray();
    }

    private void WriteNumber(string name, MapLane? lane)
    {
        if (lane is null)
        {
            _json.WriteNull(name);
        }
        else
        {
            _json.WriteNumber(name, _numbers[lane]);
        }
    }
}
