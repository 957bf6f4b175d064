using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Plans;

namespace Harvester.Play.Tests.Plans;

public sealed class LaneDirectionTests
{
    // A road to the north: the lanes to its second, northern end are east of it, those to its first end west of it.
    [Theory]
    [InlineData(1, 1, 3, 0)]
    [InlineData(1, 1, -3, 180)]
    [InlineData(0, 2, -3, 0)]
    [InlineData(2, 0, 3, 180)]
    public void Heading_is_that_of_the_lane_at_the_place(int toFirst, int toSecond, double x, double heading)
    {
        var road = new SurveyedRoad(new Vector3D(0, 0, 0), new Vector3D(0, 100, 0), toFirst, toSecond, 0);

        double found = LaneDirection.HeadingAt(road, new Vector3D(x, 50, 0));

        Assert.Equal(heading, Math.Abs(found));
    }
}
