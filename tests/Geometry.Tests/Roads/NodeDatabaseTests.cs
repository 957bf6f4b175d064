using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Roads;

public sealed class NodeDatabaseTests
{
    [Fact]
    public void Entries_of_a_two_way_road_lie_on_both_sides_of_its_median()
    {
        // To the north, 2 lanes forward and 1 back, a median of 3 m, lanes of 5.4 m. Node 1 is in the middle of the road.
        List<NodeDatabaseEntry> entries = Entries(2, 1, 3);
        NodeDatabaseEntry north = Assert.Single(entries, entry => entry is { NodeId: (1 << 16) + 7 + 1, Lanes: 2 });

        Assert.Equal(new Vector3D(0, 1, 0), north.Heading);
        Assert.False(north.OneWay);
        Assert.False(north.OnMarking);
        Assert.Equal(1.5, north.RightStart.X, 9);
        Assert.Equal(1.5 + (2 * 5.4), north.RightEnd.X, 9);
        Assert.Equal(-1.5, north.LeftStart.X, 9);
        Assert.Equal(-1.5 - 5.4, north.LeftEnd.X, 9);
        Assert.All([north.LeftStart, north.LeftEnd, north.RightStart, north.RightEnd], point => Assert.Equal(20, point.Y, 9));
        Assert.Equal(0.8, north.Confidence, 9);

        NodeDatabaseEntry south = Assert.Single(entries, entry => entry is { NodeId: (1 << 16) + 7 + 1, Lanes: 1 });
        Assert.Equal(-1, south.Heading.Y, 9);
        Assert.Equal(north.LeftEnd.X, south.RightEnd.X, 9);
        Assert.Equal(north.RightEnd.X, south.LeftEnd.X, 9);
    }

    [Theory]
    [InlineData(1, 1, null, true, false)]
    [InlineData(2, 0, null, true, true)]
    [InlineData(3, 0, null, false, true)]
    [InlineData(1, 1, 2.0, false, false)]
    public void OnMarking_depends_on_lanes_and_median(int forward, int backward, double? median, bool onMarking, bool oneWay) =>
        Assert.All(Entries(forward, backward, median), entry => Assert.Equal((onMarking, oneWay), (entry.OnMarking, entry.OneWay)));

    [Fact]
    public void Each_node_of_a_one_way_road_has_one_entry_starting_at_it()
    {
        List<NodeDatabaseEntry> entries = Entries(3, 0, null);

        // Also at the last node, where the road arrives but does not go on.
        Assert.Equal(3, entries.Count);
        Assert.All(
            entries,
            entry =>
            {
                Assert.Equal(entry.LeftStart, entry.RightStart);
                Assert.Equal(-8.1, entry.LeftEnd.X, 9);
                Assert.Equal(8.1, entry.RightEnd.X, 9);
            }
        );
    }

    [Fact]
    public void Two_way_road_has_two_entries_per_node() => Assert.Equal(6, Entries(1, 1, null).Count);

    [Fact]
    public void Entries_of_a_calibrated_road_have_its_width_and_confidence_1()
    {
        RoadNetwork road = Road(1, 1, 0);
        var right = new RoadEdge(0, IsAtStart: true, new Vector3D(4.5, 0, 0));
        var left = new RoadEdge(0, IsAtStart: false, new Vector3D(-4.5, 20, 0));
        var network = new RoadNetwork(road.Nodes, road.Links, [right, right, left, left]);

        NodeDatabaseEntry first = new NodeDatabase(new RoadCurves(network), new LaneModel(network)).Entries().First();

        Assert.Equal((4.5, LaneWidthSource.Calibrated, 1.0), (first.LaneWidth, first.LaneWidthSource, first.Confidence));
        Assert.Equal(4.5, first.RightEnd.X, 9);
    }

    private static List<NodeDatabaseEntry> Entries(int forward, int backward, double? median)
    {
        RoadNetwork network = Road(forward, backward, median);
        return [.. new NodeDatabase(new RoadCurves(network), new LaneModel(network)).Entries()];
    }

    private static RoadNetwork Road(int forward, int backward, double? median) =>
        new(
            [.. Enumerable.Range(0, 3).Select(i => new RoadNode(7, i, new Vector3D(0, i * 20, 0), "", RoadNodeFlags.None))],
            [
                new RoadLink(0, 1, forward, backward, median, RoadLinkFlags.None),
                new RoadLink(1, 2, forward, backward, median, RoadLinkFlags.None),
            ]
        );
}
