using Harvester.Driving.Controllers;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Driving.Tests.Controllers;

public sealed class PlaceBesideLineTests
{
    /// <summary>A bend of 20 m to the left, 1/m.</summary>
    private const double Left = 1 / 20.0;

    [Theory]
    [InlineData(1, 2, Left, 22, 22)] // in the middle of the only lane, 2 m right of the line
    [InlineData(1, 3, Left, 23, 22)] // a metre right of it
    [InlineData(1, 2, -Left, 18, 18)] // to the right the lane is the inner one
    [InlineData(2, 6, Left, 26, 26)] // the second of two lanes
    [InlineData(1, 3.8, Left, 23.8, 20)] // on the marking the car's place is known, and the lane's is not
    public void Bend_is_longer_outside_than_inside(
        int lanes,
        double carRightOfLine,
        double bendOfLine,
        double radiusOfCar,
        double radiusOfLane
    )
    {
        var place = new PlaceBesideLine();

        place.Observe(IndicatorCalculator.Compute(0, carRightOfLine, new LaneSection(lanes, 4), []));

        Assert.Equal(20 / radiusOfCar, place.AlongLine(1, bendOfLine), 9);
        Assert.Equal(1 / radiusOfLane, Math.Abs(place.BendOfLane(bendOfLine)), 9);
    }

    [Fact]
    public void Bend_follows_the_line_before_the_first_observation()
    {
        var place = new PlaceBesideLine();

        place.Observe(LaneIndicators.Unknown);

        Assert.Equal(1, place.AlongLine(1, Left));
        Assert.Equal(Left, place.BendOfLane(Left));
    }
}
