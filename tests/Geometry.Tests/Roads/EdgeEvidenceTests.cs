using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Roads;

/// <summary>Which points on edges prove the width of a road's lanes. The road runs to the north from the origin, 20 m.</summary>
public sealed class EdgeEvidenceTests
{
    private static readonly RoadLink TwoAndOne = new(0, 1, 2, 1, 3, RoadLinkFlags.None);

    [Fact]
    public void Width_of_a_two_way_road_follows_from_median_and_edges()
    {
        // Half the median is 1.5 m: 1.5 + 2 · 4.5 on the right, 1.5 + 4.5 on the left.
        Assert.Equal((4.5, LaneWidthSource.Calibrated), Width(TwoAndOne, Start(10.5), Start(10.5), End(-6), End(-6)));
    }

    [Fact]
    public void Width_of_a_one_way_road_follows_from_its_edges()
    {
        RoadEdge[] edges = [Start(-6), Start(-6), End(6), End(6)];

        Assert.Equal((4, LaneWidthSource.Calibrated), Width(new RoadLink(0, 1, 3, 0, null, RoadLinkFlags.None), edges));
        Assert.Equal((4, LaneWidthSource.Calibrated), Width(new RoadLink(0, 1, 0, 3, null, RoadLinkFlags.None), edges));
    }

    [Fact]
    public void Width_of_a_narrow_road_is_measured_if_its_edges_agree() =>
        Assert.Equal(
            (4.5, LaneWidthSource.Calibrated),
            Width(TwoAndOne with { Flags = RoadLinkFlags.NarrowRoad }, Start(10.5), Start(10.5), End(-6), End(-6))
        );

    [Fact]
    public void Width_is_the_middle_of_answers_that_nearly_agree()
    {
        // Lanes of 4.5, 4.55, 4.6 and 4.6 m.
        (double width, _) = Width(TwoAndOne, Start(10.5), Start(10.6), End(-6.1), End(-6.1));

        Assert.Equal(4.55, width, 9);
    }

    public static TheoryData<string, RoadEdge[]> Doubtful =>
        new()
        {
            { "nothing", [] },
            { "one side only", [Start(10.5), Start(10.5), End(10.5), End(10.5)] },
            { "each side once", [Start(10.5), End(-6)] },
            { "a side of one answer", [Start(10.5), Start(10.5), End(-6)] },
            { "sides that differ by 0.3 m a lane", [Start(10.5), Start(10.5), End(-6.3), End(-6.3)] },
            { "mirrored sides", [Start(-10.5), Start(-10.5), End(6), End(6)] },
            { "answers that change", [Start(10.5), Start(11.5), End(-6), End(-6)] },
            { "lanes of 2.9 m", [Start(1.5 + 5.8), Start(1.5 + 5.8), End(-1.5 - 2.9), End(-1.5 - 2.9)] },
            { "lanes of 7.1 m", [Start(1.5 + 14.2), Start(1.5 + 14.2), End(-1.5 - 7.1), End(-1.5 - 7.1)] },
            {
                "a point 2.2 m along the road from the square at 10.5 m",
                [Start(10.5), new RoadEdge(0, true, new Vector3D(10.5, 2.2, 5)), End(-6), End(-6)]
            },
            { "a point under the road", [Start(10.5), new RoadEdge(0, true, new Vector3D(10.5, 0, 1)), End(-6), End(-6)] },
            { "points at the nodes", [Start(0), Start(0), End(0), End(0)] },
            { "a point that is no number", [Start(10.5), Start(10.5), End(-6), End(-6), Start(double.NaN)] },
        };

    [Theory]
    [MemberData(nameof(Doubtful))]
    public void Width_is_the_constant_if_the_points_are_inconsistent(string what, RoadEdge[] edges)
    {
        Assert.True(Width(TwoAndOne, edges) == (RoadGeometry.LaneWidth, LaneWidthSource.Constant), what);
    }

    [Fact]
    public void Width_is_the_constant_without_a_known_median_or_lanes()
    {
        RoadEdge[] edges = [Start(5), Start(5), End(-5), End(-5)];

        Assert.Equal(LaneWidthSource.Calibrated, Width(new RoadLink(0, 1, 1, 1, 0, RoadLinkFlags.None), edges).Source);
        Assert.Equal(LaneWidthSource.Constant, Width(new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None), edges).Source);
        Assert.Equal(LaneWidthSource.Constant, Width(new RoadLink(0, 1, 0, 0, 0, RoadLinkFlags.None), edges).Source);
    }

    [Fact]
    public void Width_of_a_road_between_stacked_nodes_is_the_constant()
    {
        var network = new RoadNetwork([Node(0, 0), Node(1, 0)], [TwoAndOne], [Start(10.5), Start(10.5), Start(-6), Start(-6)]);

        Assert.Equal(LaneWidthSource.Constant, new LaneModel(network).WidthOf(0, isForward: true, station: 0).Source);
    }

    [Fact]
    public void Network_refuses_an_edge_of_a_missing_link() =>
        Assert.Throws<ArgumentException>(() =>
            new RoadNetwork([Node(0, 0), Node(1, 20)], [TwoAndOne], [new RoadEdge(1, true, Vector3D.Zero)])
        );

    private static (double Width, LaneWidthSource Source) Width(RoadLink link, params RoadEdge[] edges) =>
        new LaneModel(new RoadNetwork([Node(0, 0), Node(1, 20)], [link], edges)).WidthOf(0, isForward: true, station: 0);

    private static RoadEdge Start(double right) => new(0, IsAtStart: true, new Vector3D(right, 0, 5));

    private static RoadEdge End(double right) => new(0, IsAtStart: false, new Vector3D(right, 20, 5));

    private static RoadNode Node(int number, double north) => new(0, number, new Vector3D(0, north, 5), "", RoadNodeFlags.None);
}
