using System.Text.Json.Nodes;
using Harvester.Exports.Maps;
using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Tests.Maps;

/// <summary>The Argoverse 2 map of a town, read by a reader of its own and compared with the lane map.</summary>
public sealed class ArgoverseMapTests
{
    /// <summary>What is allowed between the file's borders and the map's, metres.</summary>
    private const double MaxDeviation = 0.05;

    private static readonly LaneNetwork Map = TownMap.Of(471);
    private static readonly JsonObject File = Read(Map);
    private static readonly Dictionary<string, JsonNode> Lanes = File["lane_segments"]!
        .AsObject()
        .ToDictionary(lane => (string)lane.Value!["name"]!, lane => lane.Value!, StringComparer.Ordinal);

    [Fact]
    public void Every_lane_is_there_under_its_number()
    {
        Assert.Equal(Map.Lanes.Select(lane => lane.Id).Order(StringComparer.Ordinal), Lanes.Keys.Order(StringComparer.Ordinal));
        foreach (string layer in new[] { "lane_segments", "drivable_areas", "pedestrian_crossings" })
        {
            Assert.NotEmpty(File[layer]!.AsObject());
            Assert.All(File[layer]!.AsObject(), item => Assert.Equal(item.Key, item.Value!["id"]!.ToString()));
        }
    }

    [Fact]
    public void Lanes_lead_where_the_map_says()
    {
        foreach (MapLane lane in Map.Lanes)
        {
            JsonNode written = Lanes[lane.Id];
            Assert.Equal(Ids(lane.Successors), Names(written["successors"]));
            Assert.Equal(Ids(lane.Predecessors), Names(written["predecessors"]));
            Assert.Equal(lane.LeftNeighbour?.Id, Name(written["left_neighbor_id"]));
            Assert.Equal(lane.RightNeighbour?.Id, Name(written["right_neighbor_id"]));
            Assert.Equal(lane.Junction is not null, (bool)written["is_intersection"]!);
        }
    }

    [Fact]
    public void Borders_lie_where_the_map_has_them()
    {
        foreach (MapLane lane in Map.Lanes.Where(lane => lane.Turn is null or MapTurn.Straight))
        {
            Assert.All(
                Points(Lanes[lane.Id]["left_lane_boundary"]),
                point => Assert.InRange(TownMap.DistanceFrom(lane.Left, point.X, point.Y), 0, MaxDeviation)
            );
            Assert.All(
                Points(Lanes[lane.Id]["right_lane_boundary"]),
                point => Assert.InRange(TownMap.DistanceFrom(lane.Right, point.X, point.Y), 0, MaxDeviation)
            );
        }
    }

    [Fact]
    public void Borders_are_marked_as_the_map_knows()
    {
        foreach (MapLane lane in Map.Lanes)
        {
            Assert.Equal(
                lane.Junction is not null ? "NONE"
                    : lane.RightMarking is null ? "UNKNOWN"
                    : "DASHED_WHITE",
                (string)Lanes[lane.Id]["right_lane_mark_type"]!
            );
        }
    }

    [Fact]
    public void Edges_of_a_crossing_are_its_longer_sides()
    {
        JsonNode crossing = Assert.Single(File["pedestrian_crossings"]!.AsObject()).Value!;

        // The crossing is 3 m by 8 m.
        Assert.Equal(8, Length(crossing["edge1"]), MaxDeviation);
        Assert.Equal(8, Length(crossing["edge2"]), MaxDeviation);
    }

    private static double Length(JsonNode? edge)
    {
        Vector3D[] points = Points(edge);
        return (points[1] - points[0]).Length;
    }

    private static IEnumerable<string> Ids(IEnumerable<MapLane> lanes) => lanes.Select(lane => lane.Id).Order(StringComparer.Ordinal);

    private static IEnumerable<string?> Names(JsonNode? ids) => ids!.AsArray().Select(Name).Order(StringComparer.Ordinal);

    private static string? Name(JsonNode? id) => id is null ? null : (string)File["lane_segments"]![id.ToString()]!["name"]!;

    private static Vector3D[] Points(JsonNode? line) =>
        [.. line!.AsArray().Select(point => new Vector3D((double)point!["x"]!, (double)point["y"]!, (double)point["z"]!))];

    private static JsonObject Read(LaneNetwork map)
    {
        using var stream = new MemoryStream();
        ArgoverseMap.Write(map, stream);
        return JsonNode.Parse(stream.ToArray())!.AsObject();
    }
}
