using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>The layers of a nuScenes map, version 1.3.</summary>
/// <param name="content">What it shows.</param>
/// <param name="offset">What is added to a place in the world, metres.</param>
/// <param name="size">Width and height of the map, metres.</param>
internal sealed class ExpansionLayers(ExpansionContent content, Vector2D offset, Vector2D size)
{
    private const string Version = "1.3";

    /// <summary>Half the width of the line that stands for a light, metres.</summary>
    private const double LightHalfWidth = 0.3;

    private const int Decimals = 3;
    private const string Token = "token";
    private const string PolygonToken = "polygon_token";
    private const string RoadToken = "road_segment_token";

    private readonly ExpansionGeometry _geometry = new(offset);
    private readonly Dictionary<string, ExpansionLane> _lanes = content.Lanes.ToDictionary(lane => lane.Id, StringComparer.Ordinal);
    private readonly ILookup<string, ExpansionSignal> _signalsOf = content
        .Signals.SelectMany(signal => signal.Lanes.Select(lane => (Lane: lane, Signal: signal)))
        .ToLookup(pair => pair.Lane, pair => pair.Signal, StringComparer.Ordinal);
    private readonly ILookup<string, ExpansionLane> _roads = content.Lanes.ToLookup(lane => lane.Road, StringComparer.Ordinal);

    /// <summary>Writes the file.</summary>
    public void Write(Stream stream)
    {
        using var json = new ExpansionJson(stream);
        Utf8JsonWriter writer = json.Writer;
        writer.WriteString("version", Version);
        WritePair(writer, "canvas_edge", size);
        WritePair(writer, "offset", offset);
        json.List("drivable_area", _roads, road => WriteDrivable(json, road));
        json.List("road_segment", _roads, road => WriteRoad(writer, road));
        json.List("road_block", Blocks(), block => WriteBlock(writer, block));
        json.List("lane", content.Lanes.Where(lane => !lane.IsConnector), lane => WriteLane(writer, lane));
        json.List(
            "lane_connector",
            content.Lanes.Where(lane => lane.IsConnector),
            way =>
            {
                writer.WriteString(Token, way.Id);
                writer.WriteString(PolygonToken, OutlineOf(way));
            }
        );
        json.List("ped_crossing", content.Crossings, crossing => WriteCrossing(writer, crossing));
        json.List("stop_line", content.StopLines, line => WriteStopLine(json, line));
        json.List("traffic_light", Lights, light => WriteLight(json, light));
        json.List("road_divider", Centres(), lane => WriteDivider(writer, lane, lane.Left, lane.LeftType, lane.Road));
        json.List(
            "lane_divider",
            content.Lanes.Where(lane => !lane.IsConnector && lane.Index > 0),
            lane => WriteDivider(writer, lane, lane.Left, lane.LeftType, null)
        );
        json.List<ExpansionLane>("walkway", [], _ => { });
        json.List<ExpansionLane>("carpark_area", [], _ => { });
        json.Map("arcline_path_3", content.Lanes, lane => WriteArcs(writer, lane));
        var names = content.Lanes.Select(lane => lane.Id).ToHashSet(StringComparer.Ordinal);
        json.Map(
            "connectivity",
            content.Lanes,
            lane =>
            {
                writer.WriteStartObject(lane.Id);
                json.Tokens("incoming", lane.Predecessors.Where(names.Contains));
                json.Tokens("outgoing", lane.Successors.Where(names.Contains));
                writer.WriteEndObject();
            }
        );
        _geometry.Write(json);
        json.End();
    }

    private IEnumerable<ExpansionSignal> Lights => content.Signals.Where(signal => signal.Kind == MapSignalKind.Light);

    private IEnumerable<IGrouping<string, ExpansionLane>> Blocks() =>
        content.Lanes.Where(lane => !lane.IsConnector).GroupBy(lane => lane.Block, StringComparer.Ordinal);

    /// <summary>The lanes whose left border divides the directions of their road; once if it is that of both directions.</summary>
    private IEnumerable<ExpansionLane> Centres() =>
        content.Lanes.Where(lane =>
            !lane.IsConnector
            && lane.Index == 0
            && (lane.IsForward || !lane.TouchesOncoming)
            && _roads[lane.Road].Any(other => other.IsForward != lane.IsForward)
        );

    private static string AreaOf(string road) => road + "#area";

    private static void WriteDrivable(ExpansionJson json, IGrouping<string, ExpansionLane> road)
    {
        json.Writer.WriteString(Token, AreaOf(road.Key));
        ExpansionLane[] ways = [.. road.Where(lane => lane.IsConnector)];
        json.Tokens(
            "polygon_tokens",
            ways.Length > 0
                ? ways.Select(way => way.Id + "#outline")
                : road.Select(lane => lane.Block).Distinct(StringComparer.Ordinal).Select(block => block + "#outline")
        );
    }

    private void WriteRoad(Utf8JsonWriter writer, IGrouping<string, ExpansionLane> road)
    {
        writer.WriteString(Token, road.Key);
        bool isJunction = road.First().IsConnector;
        writer.WriteString(PolygonToken, _geometry.Polygon(road.Key, "#outline", isJunction ? HullOf(road) : RoadOutline(road)));
        writer.WriteBoolean("is_intersection", isJunction);
        writer.WriteString("drivable_area_token", AreaOf(road.Key));
    }

    private static IReadOnlyList<Vector2D> HullOf(IEnumerable<ExpansionLane> ways) =>
        ConvexHull.Of(ways.SelectMany(way => way.Left.Concat(way.Right)));

    /// <summary>Along the right edge of one direction, and back along that of the other or the left edge of the only one.</summary>
    private static IEnumerable<Vector2D> RoadOutline(IEnumerable<ExpansionLane> road)
    {
        ExpansionLane[][] blocks = [.. road.GroupBy(lane => lane.IsForward).Select(block => block.OrderBy(lane => lane.Index).ToArray())];
        IEnumerable<Vector2D> back = blocks.Length > 1 ? blocks[1][^1].Right : blocks[0][0].Left.Reverse();
        return blocks[0][^1].Right.Concat(back);
    }

    private void WriteBlock(Utf8JsonWriter writer, IGrouping<string, ExpansionLane> block)
    {
        ExpansionLane[] lanes = [.. block.OrderBy(lane => lane.Index)];
        writer.WriteString(Token, block.Key);
        writer.WriteString(PolygonToken, _geometry.Polygon(block.Key, "#outline", lanes[^1].Right.Concat(lanes[0].Left.Reverse())));
        WriteEdges(writer, block.Key, lanes);
        writer.WriteString(RoadToken, lanes[0].Road);
    }

    private void WriteLane(Utf8JsonWriter writer, ExpansionLane lane)
    {
        writer.WriteString(Token, lane.Id);
        writer.WriteString(PolygonToken, OutlineOf(lane));
        writer.WriteString("lane_type", "CAR");
        WriteEdges(writer, lane.Id, [lane]);
        WriteSegments(writer, "left_lane_divider_segments", lane.Left, lane.LeftType);
        WriteSegments(writer, "right_lane_divider_segments", lane.Right, lane.RightType);
    }

    private string OutlineOf(ExpansionLane lane) => _geometry.Polygon(lane.Id, "#outline", lane.Right.Concat(lane.Left.Reverse()));

    /// <summary>The lines across lanes where they begin and end, from left to right.</summary>
    private void WriteEdges(Utf8JsonWriter writer, string token, ExpansionLane[] lanes)
    {
        IEnumerable<Vector2D> across = lanes.Select(lane => lane.Right[0]).Prepend(lanes[0].Left[0]);
        writer.WriteString("from_edge_line_token", _geometry.Line(token, "#from", across));
        across = lanes.Select(lane => lane.Right[^1]).Prepend(lanes[0].Left[^1]);
        writer.WriteString("to_edge_line_token", _geometry.Line(token, "#to", across));
    }

    private void WriteSegments(Utf8JsonWriter writer, string name, IReadOnlyList<Vector2D> points, string type)
    {
        writer.WriteStartArray(name);
        foreach (Vector2D point in points)
        {
            writer.WriteStartObject();
            writer.WriteString("node_token", _geometry.NodeToken(point));
            writer.WriteString("segment_type", type);
            writer.WriteEndObject();
        }

        writer.WriteEndArray();
    }

    private void WriteDivider(Utf8JsonWriter writer, ExpansionLane lane, IReadOnlyList<Vector2D> points, string type, string? road)
    {
        const string part = "#left";
        writer.WriteString(Token, lane.Id + part);
        writer.WriteString("line_token", _geometry.Line(lane.Id, part, points));
        if (road is not null)
        {
            writer.WriteString(RoadToken, road);
        }

        WriteSegments(writer, "lane_divider_segments", points, type);
    }

    private void WriteCrossing(Utf8JsonWriter writer, ExpansionCrossing crossing)
    {
        writer.WriteString(Token, crossing.Id);
        writer.WriteString(PolygonToken, _geometry.Polygon(crossing.Id, "#outline", crossing.Corners));
        writer.WriteString(RoadToken, crossing.Road);
    }

    private void WriteStopLine(ExpansionJson json, ExpansionStopLine line)
    {
        ExpansionSignal[] signals = [.. line.Lanes.SelectMany(lane => _signalsOf[lane]).Distinct()];
        ExpansionSignal[] lights = [.. signals.Where(signal => signal.Kind == MapSignalKind.Light)];
        json.Writer.WriteString(Token, line.Id);
        json.Writer.WriteString(PolygonToken, _geometry.Polygon(line.Id, "#outline", line.Outline));
        json.Writer.WriteString(
            "stop_line_type",
            lights.Length > 0 ? "TRAFFIC_LIGHT"
                : signals.Any(signal => signal.Kind == MapSignalKind.StopSign) ? "STOP_SIGN"
                : signals.Length > 0 ? "YIELD"
                : "TURN_STOP"
        );
        json.Tokens("ped_crossing_tokens", []);
        json.Tokens("traffic_light_tokens", lights.Select(light => light.Id));
        json.Writer.WriteString("road_block_token", _lanes[line.Lanes[0]].Block);
    }

    private void WriteLight(ExpansionJson json, ExpansionSignal light)
    {
        Vector2D facing = light.Facing;
        Vector2D right = new Vector2D(-facing.Y, facing.X) * LightHalfWidth;
        var place = new Vector2D(light.Position.X, light.Position.Y);
        json.Writer.WriteString(Token, light.Id);
        json.Writer.WriteString("line_token", _geometry.Line(light.Id, "#line", [place - right, place + right]));
        json.Writer.WriteString("traffic_light_type", "VERTICAL");
        json.Tokens("from_road_block_tokens", light.Lanes.Select(lane => _lanes[lane].Block).Distinct(StringComparer.Ordinal));
        json.Tokens("items", []);
        json.Writer.WriteStartObject("pose");
        Vector2D local = _geometry.Local(place.X, place.Y);
        (string, double)[] numbers =
        [
            ("tx", local.X),
            ("ty", local.Y),
            ("tz", light.Position.Z),
            ("rx", 0),
            ("ry", 0),
            ("rz", Math.Atan2(facing.Y, facing.X)),
        ];
        foreach ((string name, double value) in numbers)
        {
            json.Writer.WriteNumber(name, Math.Round(value, Decimals));
        }

        json.Writer.WriteEndObject();
    }

    /// <summary>Each arc is a path of three pieces (Dubins), of which two have no length.</summary>
    private void WriteArcs(Utf8JsonWriter writer, ExpansionLane lane)
    {
        const double straightRadius = 1000;
        const int digits = 9;
        writer.WriteStartArray(lane.Id);
        foreach (LaneArc arc in lane.MakeArcs())
        {
            writer.WriteStartObject();
            WritePose(writer, "start_pose", (arc.X, arc.Y, arc.Heading));
            WritePose(writer, "end_pose", arc.At(arc.Length));
            writer.WriteString("shape", arc.Curvature < 0 && !arc.IsStraight ? "RSR" : "LSL");
            writer.WriteNumber("radius", arc.IsStraight ? straightRadius : Math.Round(1 / Math.Abs(arc.Curvature), digits));
            writer.WriteStartArray("segment_length");
            writer.WriteNumberValue(arc.IsStraight ? 0 : Math.Round(arc.Length, digits));
            writer.WriteNumberValue(arc.IsStraight ? Math.Round(arc.Length, digits) : 0);
            writer.WriteNumberValue(0);
            writer.WriteEndArray();
            writer.WriteEndObject();
        }

        writer.WriteEndArray();
    }

    private void WritePose(Utf8JsonWriter writer, string name, (double X, double Y, double Heading) pose)
    {
        const int headingDecimals = 9;
        Vector2D place = _geometry.Local(pose.X, pose.Y);
        writer.WriteStartArray(name);
        writer.WriteNumberValue(place.X);
        writer.WriteNumberValue(place.Y);
        writer.WriteNumberValue(Math.Round(Math.IEEERemainder(pose.Heading, 2 * Math.PI), headingDecimals));
        writer.WriteEndArray();
    }

    private static void WritePair(Utf8JsonWriter writer, string name, Vector2D pair)
    {
        writer.WriteStartArray(name);
        writer.WriteNumberValue(pair.X);
        writer.WriteNumberValue(pair.Y);
        writer.WriteEndArray();
    }
}
