using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Roads;

public sealed class LaneSectionOfWidthsTests
{
    private static readonly LaneSection Section = new([3.0, 4.0, 5.0]);

    [Fact]
    public void Edges_and_lanes_follow_the_widths()
    {
        Assert.Equal([0, 3, 7, 12], Enumerable.Range(0, 4).Select(Section.Edge));
        Assert.Equal((3, 12, 4), (Section.LaneCount, Section.Width, Section.LaneWidth));
        Assert.Equal([1.5, 5, 9.5], Enumerable.Range(0, 3).Select(Section.MiddleOf));
        Assert.Equal([null, 0, 0, 1, 1, 2, 2, null], new[] { -0.1, 0, 2.9, 3, 6.9, 7, 11.9, 12 }.Select(offset => Section.LaneAt(offset)));
        Assert.Equal([0, 0, 1, 1, 2, 2, 3, 3], new[] { -5.0, 1.4, 1.6, 4.9, 5.1, 9.4, 9.6, 20 }.Select(Section.NearestEdge));
    }

    [Fact]
    public void Sections_are_equal_if_all_widths_are()
    {
        Assert.Equal(new LaneSection([3.0, 4.0, 5.0]), Section);
        Assert.NotEqual(new LaneSection([5.0, 4.0, 3.0]), Section);
        Assert.NotEqual(new LaneSection(3, 4), Section);
    }

    [Fact]
    public void Widths_are_listed_if_they_differ()
    {
        Assert.Equal([3.0, 4.0, 5.0], Section.LaneWidths!.Select(width => Math.Round(width, 9)));
        Assert.Null(new LaneSection([3.5]).LaneWidths);
        Assert.Null(new LaneSection([3.1, 3.1004]).LaneWidths);
        Assert.Null(new LaneSection(3, 4).LaneWidths);
    }

    [Fact]
    public void Width_must_be_positive()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new LaneSection([3.0, 0]));
        Assert.Throws<ArgumentOutOfRangeException>(() => new LaneSection([]));
    }

    [Fact]
    public void Indicators_name_the_edges_of_each_lane()
    {
        // In the middle of lane 1, 5 m right of the left edge.
        LaneIndicators at = IndicatorCalculator.Compute(0, 5, Section, [new VehicleAhead(2, 20)]);

        Assert.Equal((-5, -2, 2, 7), (at.ToMarkingLL.Value, at.ToMarkingML.Value, at.ToMarkingMR.Value, at.ToMarkingRR.Value));
        Assert.Equal(20, at.DistRR.Value);
        Assert.False(at.ToMarkingM.IsValid);
    }

    [Fact]
    public void Torcs_stretches_each_lane_to_four_metres()
    {
        LaneIndicators at = IndicatorCalculator.Compute(0, 5, Section, []);

        LaneIndicators torcs = TorcsEquivalent.Of(at, Section, 5, at.Angle);

        Assert.Equal((-6, -2, 2, 6), (torcs.ToMarkingLL.Value, torcs.ToMarkingML.Value, torcs.ToMarkingMR.Value, torcs.ToMarkingRR.Value));
    }
}
