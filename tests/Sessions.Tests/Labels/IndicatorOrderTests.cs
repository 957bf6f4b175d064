using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;

namespace Harvester.Sessions.Tests.Labels;

public sealed class IndicatorOrderTests
{
    [Theory]
    [InlineData(3, 6.0)] // mid-lane
    [InlineData(3, 7.25)] // both systems
    [InlineData(3, 8.0)] // on an inner marking
    [InlineData(3, 13.9)] // outside the right edge
    [InlineData(3, -1.9)] // outside the left edge
    [InlineData(2, 0.6)]
    [InlineData(1, 2.0)]
    public void FromValues_of_what_torcs_gives_finds_the_flags_again(int lanes, double offset)
    {
        LaneIndicators indicators = TorcsEquivalent.Of(
            IndicatorCalculator.Compute(0.2, offset, new LaneSection(lanes, 4), [new VehicleAhead(0, 30)]),
            new LaneSection(lanes, 4)
        );

        Assert.Equal(indicators, IndicatorOrder.FromValues(IndicatorOrder.Values(indicators)));
    }

    [Fact]
    public void Values_are_in_the_order_of_the_table() =>
        Assert.Equal(IndicatorTable.All.Select(indicator => indicator.Range.InactiveValue), IndicatorOrder.Values(LaneIndicators.Unknown));

    [Fact]
    public void FromValues_of_another_count_is_refused() =>
        Assert.Throws<ArgumentException>(() => IndicatorOrder.FromValues(new double[12]));
}
