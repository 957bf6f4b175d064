using Harvester.Capture.Driving.Controllers;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Tests.Controllers;

public sealed class ControllerTests
{
    private const double TorcsLock = 0.541052;
    private const double GameLock = 0.6981317;

    [Theory]
    [InlineData(5)]
    [InlineData(10)]
    [InlineData(20)]
    public void DeepDriving_takes_back_a_metre_within_eight_seconds(double speed)
    {
        var loop = new ClosedLoop(new DeepDrivingController(), new LaneSection(1, 4), TorcsLock) { Offset = 3, Speed = speed };

        loop.Run(8);

        Assert.Equal(2, loop.Offset, 0.1);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(10)]
    [InlineData(14)]
    public void Stanley_takes_back_a_metre_without_leaving_the_lane(double speed)
    {
        var section = new LaneSection(2, 5.4);
        var loop = new ClosedLoop(new StanleyController(new StanleyOptions()), section, GameLock) { Offset = 3.7, Speed = speed };

        loop.Run(8, at => Assert.InRange(at.Offset, 0, 5.4));

        Assert.Equal(2.7, loop.Offset, 0.1);
    }

    [Fact]
    public void Stanley_stops_behind_a_standing_vehicle_in_the_only_lane()
    {
        var loop = new ClosedLoop(new StanleyController(new StanleyOptions()), new LaneSection(1, 5.4), GameLock) { Lead = (0, 60, 0) };

        loop.Run(30, at => Assert.True(at.Lead!.Value.Along - at.Along > 5, "The car ran into the vehicle ahead."));

        Assert.True(loop.Speed < 0.5);
    }

    [Fact]
    public void Stanley_moves_to_the_free_lane_when_blocked_and_passes()
    {
        var loop = new ClosedLoop(new StanleyController(new StanleyOptions()), new LaneSection(2, 5.4), GameLock)
        {
            Offset = 8.1,
            Lead = (1, 60, 4),
        };

        loop.Run(40, at => Assert.True(
            at.Lead!.Value.Along - at.Along is > 5 or < -5 || at.Offset < 5.4 + 0.5, "The car ran into the vehicle ahead."));

        Assert.True(loop.Along > loop.Lead!.Value.Along);
        Assert.Equal(2.7, loop.Offset, 0.2);
    }

    [Fact]
    public void DeepDriving_moves_to_the_free_lane_when_blocked_and_passes()
    {
        var loop = new ClosedLoop(new DeepDrivingController(), new LaneSection(3, 4), TorcsLock)
        {
            Offset = 6,
            Lead = (1, 120, 8),
        };

        loop.Run(60);

        Assert.True(loop.Along > loop.Lead!.Value.Along);
    }
}
