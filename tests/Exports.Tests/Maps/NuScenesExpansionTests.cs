using System.Text.Json.Nodes;
using Harvester.Exports.Maps;
using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Tests.Maps;

/// <summary>The nuScenes map of a town, read as the format's own reader does and compared with the lane map.</summary>
public sealed class NuScenesExpansionTests
{
    /// <summary>What is allowed between the file's arcs and the map's middles, metres.</summary>
    private const double MaxDeviation = 0.05;

    /// <summary>Rounding of poses, which have three decimals, and of what follows from them, metres.</summary>
    private const double MaxGap = 0.003;

    /// <summary>Rounding of the headings of arcs, radians.</summary>
    private const double MaxKink = 1e-6;

    private const double StepMetres = 0.5;

    private static readonly LaneNetwork Map = TownMap.Of(471);
    private static readonly JsonObject File = Read(Map);
    private static readonly Vector2D Offset = new((double)File["offset"]![0]!, (double)File["offset"]![1]!);

    [Fact]
    public void Tokens_differ_and_those_that_are_named_exist()
    {
        Dictionary<string, HashSet<string>> tokens = File.Where(layer => layer.Value is JsonArray)
            .Where(layer => layer.Key is not ("canvas_edge" or "offset"))
            .ToDictionary(layer => layer.Key, layer => TokensOf(layer.Key).ToHashSet(StringComparer.Ordinal), StringComparer.Ordinal);
        Assert.All(tokens, layer => Assert.Equal(Records(layer.Key).Length, layer.Value.Count));
        (string Layer, string Field, string Target)[] links =
        [
            ("polygon", "exterior_node_tokens", "node"),
            ("line", "node_tokens", "node"),
            ("drivable_area", "polygon_tokens", "polygon"),
            ("road_segment", "polygon_token", "polygon"),
            ("road_segment", "drivable_area_token", "drivable_area"),
            ("road_block", "polygon_token", "polygon"),
            ("road_block", "road_segment_token", "road_segment"),
            ("road_block", "from_edge_line_token", "line"),
            ("road_block", "to_edge_line_token", "line"),
            ("lane", "polygon_token", "polygon"),
            ("lane", "from_edge_line_token", "line"),
            ("lane", "to_edge_line_token", "line"),
            ("lane_connector", "polygon_token", "polygon"),
            ("ped_crossing", "polygon_token", "polygon"),
            ("ped_crossing", "road_segment_token", "road_segment"),
            ("stop_line", "polygon_token", "polygon"),
            ("stop_line", "road_block_token", "road_block"),
            ("stop_line", "traffic_light_tokens", "traffic_light"),
            ("road_divider", "line_token", "line"),
            ("road_divider", "road_segment_token", "road_segment"),
            ("lane_divider", "line_token", "line"),
            ("traffic_light", "line_token", "line"),
            ("traffic_light", "from_road_block_tokens", "road_block"),
        ];
        foreach ((string layer, string field, string target) in links)
        {
            Assert.All(
                Records(layer).SelectMany(record => record[field] is JsonArray many ? many.Select(Text) : [Text(record[field])]),
                token => Assert.Contains(token, tokens[target])
            );
        }

        Assert.All(
            Records("lane").Concat(Records("lane_divider")).SelectMany(Segments),
            segment => Assert.Contains(Text(segment["node_token"]), tokens["node"])
        );
    }

    [Fact]
    public void Nodes_lie_on_the_canvas_and_the_version_is_1_3()
    {
        Assert.Equal("1.3", (string)File["version"]!);
        foreach (JsonObject node in Records("node"))
        {
            Assert.InRange((double)node["x"]!, 0, (double)File["canvas_edge"]![0]!);
            Assert.InRange((double)node["y"]!, 0, (double)File["canvas_edge"]![1]!);
        }
    }

    [Fact]
    public void Every_lane_and_way_leads_where_the_map_says()
    {
        Assert.Equal(Ids(Map.Lanes.Where(lane => lane.Junction is null)), TokensOf("lane").Order(StringComparer.Ordinal));
        Assert.Equal(Ids(Map.Lanes.Where(lane => lane.Junction is not null)), TokensOf("lane_connector").Order(StringComparer.Ordinal));
        foreach (MapLane lane in Map.Lanes)
        {
            JsonNode links = File["connectivity"]![lane.Id]!;
            Assert.Equal(Ids(lane.Successors), links["outgoing"]!.AsArray().Select(Text).Order(StringComparer.Ordinal));
            Assert.Equal(Ids(lane.Predecessors), links["incoming"]!.AsArray().Select(Text).Order(StringComparer.Ordinal));
        }
    }

    [Fact]
    public void Arcs_follow_the_middle_without_gap_or_bend()
    {
        foreach (MapLane lane in Map.Lanes)
        {
            (double X, double Y, double Heading)? last = null;
            foreach (JsonNode? path in File["arcline_path_3"]![lane.Id]!.AsArray())
            {
                double[] start = [.. path!["start_pose"]!.AsArray().Select(number => (double)number!)];
                double[] end = [.. path["end_pose"]!.AsArray().Select(number => (double)number!)];
                if (last is { } before)
                {
                    Assert.InRange(Math.Abs(before.X - start[0]) + Math.Abs(before.Y - start[1]), 0, MaxGap);
                    Assert.InRange(Math.Abs(Math.IEEERemainder(before.Heading - start[2], 2 * Math.PI)), 0, MaxKink);
                }

                foreach ((double x, double y, double heading) in Along(path, start))
                {
                    Assert.InRange(TownMap.DistanceFrom(lane.Centre, x - Offset.X, y - Offset.Y), 0, MaxDeviation);
                    last = (x, y, heading);
                }

                Assert.InRange(Math.Abs(last!.Value.X - end[0]) + Math.Abs(last.Value.Y - end[1]), 0, MaxGap);
            }

            Assert.InRange(TownMap.DistanceFrom(lane.Centre, last!.Value.X - Offset.X, last.Value.Y - Offset.Y), 0, MaxDeviation);
            Assert.Equal(lane.Centre[^1].X + Offset.X, last.Value.X, MaxDeviation);
            Assert.Equal(lane.Centre[^1].Y + Offset.Y, last.Value.Y, MaxDeviation);
        }
    }

    [Fact]
    public void Middles_lie_in_the_polygons_of_lanes_and_blocks()
    {
        Dictionary<string, JsonObject> nodes = ByToken("node");
        Dictionary<string, JsonObject> polygons = ByToken("polygon");
        foreach (MapLane lane in Map.Lanes.Where(lane => lane.Junction is null))
        {
            Vector3D middle = (lane.Centre[0] + lane.Centre[1]) * 0.5;
            string block = lane.Id[..^1];
            foreach (
                string polygon in new[]
                {
                    Text(ByToken("lane")[lane.Id]["polygon_token"]),
                    Text(ByToken("road_block")[block]["polygon_token"]),
                }
            )
            {
                Vector2D[] corners =
                [
                    .. polygons[polygon]["exterior_node_tokens"]!
                        .AsArray()
                        .Select(token => nodes[Text(token)])
                        .Select(node => new Vector2D((double)node["x"]!, (double)node["y"]!)),
                ];
                Assert.True(Contains(corners, middle.X + Offset.X, middle.Y + Offset.Y), $"{lane.Id} in {polygon}");
            }
        }
    }

    [Fact]
    public void Stop_lines_of_lights_and_signs_have_their_cues()
    {
        MapSignal light = Map.Signals.First(signal => signal.Kind == MapSignalKind.Light);
        JsonObject line = ByToken("stop_line")[light.StopLine!.Id];
        MapSignal sign = Map.Signals.First(signal => signal.Kind == MapSignalKind.StopSign);

        Assert.Equal("TRAFFIC_LIGHT", Text(line["stop_line_type"]));
        Assert.Equal([light.Id], line["traffic_light_tokens"]!.AsArray().Select(Text));
        Assert.Equal([light.Lanes[0].Id[..^1]], ByToken("traffic_light")[light.Id]["from_road_block_tokens"]!.AsArray().Select(Text));
        Assert.Equal("STOP_SIGN", Text(ByToken("stop_line")[sign.StopLine!.Id]["stop_line_type"]));
        Assert.Equal(Map.Crossings.Count, Records("ped_crossing").Length);
    }

    [Fact]
    public void Dividers_are_painted_as_the_map_knows()
    {
        MapLane lane = Map.Lanes.First(lane => lane.RightMarking is not null);

        Assert.All(
            Segments(ByToken("lane")[lane.Id], "right_lane_divider_segments"),
            segment => Assert.Equal("DOUBLE_DASHED_WHITE", Type(segment))
        );
        Assert.All(
            Segments(ByToken("lane_divider")[lane.RightNeighbour!.Id + "#left"]),
            segment => Assert.Equal("DOUBLE_DASHED_WHITE", Type(segment))
        );
        Assert.Contains(Records("lane").SelectMany(Segments), segment => Type(segment) == "NIL");
    }

    /// <summary>Poses along a path of three pieces, left, right or straight, by turning in small steps.</summary>
    private static IEnumerable<(double X, double Y, double Heading)> Along(JsonNode path, double[] start)
    {
        string shape = Text(path["shape"]);
        double radius = (double)path["radius"]!;
        (double x, double y, double heading) = (start[0], start[1], start[2]);
        yield return (x, y, heading);
        for (int piece = 0; piece < shape.Length; piece++)
        {
            double length = (double)path["segment_length"]![piece]!;
            double curvature = shape[piece] switch
            {
                'L' => 1 / radius,
                'R' => -1 / radius,
                _ => 0,
            };
            int steps = (int)Math.Ceiling(length / StepMetres);
            for (int i = 0; i < steps; i++)
            {
                // The chord of an arc of angle a and length s has the length s · sin(a/2) / (a/2) and the mean direction.
                double half = curvature * length / steps / 2;
                double chord = length / steps * (half == 0 ? 1 : Math.Sin(half) / half);
                x += chord * Math.Cos(heading + half);
                y += chord * Math.Sin(heading + half);
                heading += 2 * half;
                yield return (x, y, heading);
            }
        }
    }

    private static bool Contains(Vector2D[] corners, double x, double y)
    {
        bool isInside = false;
        for (int i = 0, j = corners.Length - 1; i < corners.Length; j = i++)
        {
            (Vector2D a, Vector2D b) = (corners[i], corners[j]);
            isInside ^= (a.Y > y) != (b.Y > y) && x < a.X + ((b.X - a.X) * (y - a.Y) / (b.Y - a.Y));
        }

        return isInside;
    }

    private static IEnumerable<JsonNode> Segments(JsonObject record) =>
        record
            .Where(field => field.Key.EndsWith("divider_segments", StringComparison.Ordinal))
            .SelectMany(field => field.Value!.AsArray())!;

    private static JsonArray Segments(JsonObject record, string field) => record[field]!.AsArray();

    private static string Type(JsonNode? segment) => Text(segment!["segment_type"]);

    private static Dictionary<string, JsonObject> ByToken(string layer) =>
        Index.GetOrAdd(layer, name => Records(name).ToDictionary(record => Text(record["token"]), StringComparer.Ordinal));

    private static readonly System.Collections.Concurrent.ConcurrentDictionary<string, Dictionary<string, JsonObject>> Index = new();

    private static JsonObject[] Records(string layer) => [.. File[layer]!.AsArray().Select(record => record!.AsObject())];

    private static IEnumerable<string> TokensOf(string layer) => Records(layer).Select(record => Text(record["token"]));

    private static IEnumerable<string> Ids(IEnumerable<MapLane> lanes) => lanes.Select(lane => lane.Id).Order(StringComparer.Ordinal);

    private static string Text(JsonNode? node) => (string)node!;

    private static JsonObject Read(LaneNetwork map)
    {
        using var stream = new MemoryStream();
        NuScenesExpansion.Write(map, stream);
        return JsonNode.Parse(stream.ToArray())!.AsObject();
    }
}
