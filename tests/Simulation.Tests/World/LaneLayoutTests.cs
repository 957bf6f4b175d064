using Harvester.Geometry.Roads;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.World;

public class LaneLayoutTests
{
    [Fact]
    public void ToString_lists_lanes_and_widths()
    {
        string text = new LaneLayout(2, 1, 5.4, 3).ToString();

        Assert.Contains("Forward = 2, Backward = 1", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(1, 1, 0.0, RoadLinkFlags.None)]
    [InlineData(2, 2, 4.0, RoadLinkFlags.None)]
    [InlineData(3, 1, 0.0, RoadLinkFlags.NarrowRoad)]
    [InlineData(3, 0, 0.0, RoadLinkFlags.None)]
    public void Markings_lie_where_the_lane_rule_says(int forward, int backward, double median, RoadLinkFlags flags)
    {
        RoadLink link = new(0, 1, forward, backward, median, flags);
        LaneLayout layout = LaneLayout.Of(link);
        double width = RoadGeometry.LaneWidthOf(link);
        double[] dashed = [.. layout.Markings().Where(marking => marking.Kind == MarkingKind.LaneDashed).Select(marking => marking.Offset)];
        for (int i = 1; i < forward; i++)
        {
            double expected = RoadGeometry.MarkingOffset(link, i, width);
            Assert.Contains(dashed, offset => Math.Abs(offset - expected) < 1e-12);
        }

        Assert.Equal(RoadGeometry.MarkingOffset(link, forward, width), layout.RightEdge, 12);
        Assert.Equal(Math.Max(0, forward - 1) + Math.Max(0, backward - 1), dashed.Length);
        for (int lane = 0; lane < forward; lane++)
        {
            double centre = layout.LaneCentre(forward: true, lane);
            Assert.Equal(
                (RoadGeometry.MarkingOffset(link, lane, width) + RoadGeometry.MarkingOffset(link, lane + 1, width)) / 2,
                centre,
                12
            );
            Assert.Equal((true, lane), layout.LaneAt(centre));
        }
    }

    [Fact]
    public void LaneCentre_two_lanes_with_median()
    {
        LaneLayout layout = new(2, 2, 5.4, 4);

        // 4/2 + 5.4/2 = 4.7 and one lane further 10.1; mirrored for those who come.
        Assert.Equal(4.7, layout.LaneCentre(forward: true, 0), 12);
        Assert.Equal(10.1, layout.LaneCentre(forward: true, 1), 12);
        Assert.Equal(-4.7, layout.LaneCentre(forward: false, 0), 12);
        Assert.Null(layout.LaneAt(1.9));
        Assert.Equal(12.8, layout.RightEdge, 12);
    }
}
