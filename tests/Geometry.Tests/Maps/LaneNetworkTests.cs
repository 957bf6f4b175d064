using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Maps;

/// <summary>The lane map of roads drawn by hand.</summary>
public sealed class LaneNetworkTests
{
    private const double Arm = 60;

    [Fact]
    public void Crossing_has_three_ways_from_each_single_lane()
    {
        LaneNetwork map = Crossing(1);

        MapJunction junction = Assert.Single(map.Junctions);
        Assert.Equal(12, junction.Ways.Count);
        Assert.All(
            map.Segments.Select(segment => segment.Forward[0]),
            lane => Assert.Equal([MapTurn.Straight, MapTurn.Left, MapTurn.Right], lane.Successors.Select(way => way.Turn!.Value).Order())
        );
        Assert.All(junction.Ways, way => Assert.NotEqual(way.Predecessors[0].Link, way.Successors[0].Link));
    }

    [Fact]
    public void Turns_start_from_the_lane_on_their_side()
    {
        MapLane[] ways = [.. Crossing(2).Junctions[0].Ways];

        Assert.All(ways.Where(way => way.Turn == MapTurn.Left), way => Assert.Null(way.Predecessors[0].LeftNeighbour));
        Assert.All(ways.Where(way => way.Turn == MapTurn.Right), way => Assert.Null(way.Predecessors[0].RightNeighbour));
        Assert.Equal(8, ways.Count(way => way.Turn == MapTurn.Straight));
    }

    [Fact]
    public void Ways_begin_and_end_where_their_lanes_do()
    {
        foreach (MapLane way in Crossing(2).Junctions[0].Ways)
        {
            Assert.Equal(0, (way.Predecessors[0].Centre[^1] - way.Centre[0]).Length, 1e-9);
            Assert.Equal(0, (way.Successors[0].Left[0] - way.Left[^1]).Length, 1e-9);
            Assert.Equal(0, (way.Predecessors[0].Right[^1] - way.Right[0]).Length, 1e-9);
        }
    }

    [Fact]
    public void Neighbours_share_an_edge()
    {
        RoadSegment road = Crossing(2).Segments[0];

        Assert.Same(road.Forward[1], road.Forward[0].RightNeighbour);
        Assert.Same(road.Backward[0], road.Forward[0].Oncoming);
        Assert.Null(road.Forward[1].Oncoming);
        Assert.Equal(road.Forward[0].Right, road.Forward[1].Left);
        Assert.Equal(0, (road.Forward[0].Left[0] - road.Backward[0].Left[^1]).Length, 1e-9);
        Assert.Equal(RoadGeometry.LaneWidth, (road.Forward[0].Left[0] - road.Forward[0].Right[0]).Length, 1e-9);
    }

    [Fact]
    public void Names_follow_from_the_nodes_whatever_the_order_of_links()
    {
        string[] names = [.. Crossing(1).Lanes.Select(lane => lane.Id).Order(StringComparer.Ordinal)];

        Assert.Equal(names, Crossing(1, isReversed: true).Lanes.Select(lane => lane.Id).Order(StringComparer.Ordinal));
        Assert.Contains("7:1-7:0/f0", names);
        Assert.Contains("7:1-7:0/f0>7:2-7:0/b0", names);
    }

    [Fact]
    public void Lanes_continue_past_a_node_on_a_road()
    {
        LaneNetwork map = MapOf([new(0, 0, 0), new(50, 0, 0), new(100, 0, 0)], [(0, 1, 2), (2, 1, 2)]);

        Assert.Empty(map.Junctions);
        Assert.Equal(["7:2-7:1/b0"], map.Find("7:0-7:1/f0")!.Successors.Select(lane => lane.Id));
        Assert.Equal(["7:2-7:1/b1"], map.Find("7:0-7:1/f1")!.Successors.Select(lane => lane.Id));
        Assert.Equal(["7:0-7:1/b1"], map.Find("7:2-7:1/f1")!.Successors.Select(lane => lane.Id));
    }

    [Fact]
    public void Nodes_at_one_place_leave_no_way_without_a_length()
    {
        LaneNetwork map = MapOf([new(0, 0, 0), new(50, 0, 0), new(50, 0, 0), new(100, 0, 0)], [(0, 1, 1), (1, 2, 1), (2, 3, 1)]);

        Assert.NotEmpty(map.Lanes);
        Assert.All(map.Lanes, lane => Assert.True((lane.Centre[^1] - lane.Centre[0]).Length > 0));
        Assert.All(map.Lanes.SelectMany(lane => lane.Centre), point => Assert.True(double.IsFinite(point.X) && double.IsFinite(point.Y)));
        Assert.NotEmpty(map.Find("7:0-7:1/f0")!.Successors);
    }

    [Fact]
    public void Ways_lead_where_the_links_within_the_junction_do()
    {
        // Two nodes of one junction, with a link between them that is driven from the west to the east only.
        RoadNode NodeAt(int number, double x, double y) => new(7, number, new Vector3D(x, y, 0), "", RoadNodeFlags.None);
        RoadLink Road(int from, int to, int back) => new(from, to, 1, back, null, RoadLinkFlags.None);
        var network = new RoadNetwork(
            [NodeAt(0, 0, 0), NodeAt(1, 8, 0), NodeAt(2, -Arm, 0), NodeAt(3, Arm, 0), NodeAt(4, 0, Arm), NodeAt(5, 8, -Arm)],
            [Road(0, 1, 0), Road(2, 0, 1), Road(3, 1, 1), Road(4, 0, 1), Road(5, 1, 1)]
        );
        var map = LaneNetwork.Of(new RoadCurves(network), new LaneModel(network));
        string[] From(string lane) => [.. map.Find(lane)!.Successors.Select(way => way.Successors[0].Id).Order(StringComparer.Ordinal)];

        Assert.Single(map.Junctions);
        Assert.Equal(["7:3-7:1/b0", "7:4-7:0/b0", "7:5-7:1/b0"], From("7:2-7:0/f0"));
        Assert.Equal(["7:5-7:1/b0"], From("7:3-7:1/f0"));
    }

    private static LaneNetwork Crossing(int lanes, bool isReversed = false)
    {
        (int, int, int)[] links = [(1, 0, lanes), (2, 0, lanes), (3, 0, lanes), (4, 0, lanes)];
        return MapOf(
            [new(0, 0, 0), new(Arm, 0, 1), new(0, Arm, 2), new(-Arm, 0, 3), new(0, -Arm, 4)],
            isReversed ? [.. links.Reverse()] : links
        );
    }

    private static LaneNetwork MapOf(Vector3D[] nodes, (int From, int To, int Lanes)[] links)
    {
        var network = new RoadNetwork(
            [.. nodes.Select((place, number) => new RoadNode(7, number, place, "", RoadNodeFlags.None))],
            [.. links.Select(link => new RoadLink(link.From, link.To, link.Lanes, link.Lanes, null, RoadLinkFlags.None))]
        );
        return LaneNetwork.Of(new RoadCurves(network), new LaneModel(network));
    }
}
