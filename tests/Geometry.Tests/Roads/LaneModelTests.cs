using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Roads;

public sealed class LaneModelTests
{
    private static readonly RoadNetwork Network = new(
        [.. Enumerable.Range(0, 4).Select(i => new RoadNode(0, i, new Vector3D(0, i * 10, 0), "", RoadNodeFlags.None))],
        [
            new RoadLink(0, 1, 2, 1, 3, RoadLinkFlags.None),
            new RoadLink(1, 2, 3, 0, null, RoadLinkFlags.None),
            new RoadLink(2, 3, 1, 1, null, RoadLinkFlags.NarrowRoad),
        ]
    );

    [Fact]
    public void WidthOf_without_calibration_is_one_of_the_constants()
    {
        Assert.Equal((5.4, LaneWidthSource.Constant), new LaneModel(Network).WidthOf(0, isForward: true, station: 0));
        Assert.Equal((4.0, LaneWidthSource.NarrowConstant), new LaneModel(Network).WidthOf(2, isForward: true, station: 0));
        Assert.Equal((5.0, LaneWidthSource.Constant), new LaneModel(Network, laneWidth: 5).WidthOf(0, isForward: true, station: 0));
    }

    [Fact]
    public void LanesOf_begins_at_half_the_median_or_half_the_one_way_road()
    {
        var model = new LaneModel(Network);

        Assert.Equal(1.5, model.LanesOf(0, isForward: true, station: 0)!.Value.LeftEdge);
        // Three lanes of 5.4 m centred on the line begin 8.1 m left of it.
        Assert.Equal(-8.1, model.LanesOf(1, isForward: true, station: 0)!.Value.LeftEdge, 9);
        Assert.Null(model.LanesOf(1, isForward: false, station: 0));
    }
}
