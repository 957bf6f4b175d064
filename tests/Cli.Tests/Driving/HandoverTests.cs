using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Runs.Driving;

namespace Harvester.Cli.Tests.Driving;

public sealed class HandoverTests
{
    [Fact]
    public void Decide_controller_drives_in_known_lanes() =>
        Assert.True(new Handover().Decide(Seen(InLane(0), InLane(0)), needsOwnDriver: false));

    [Fact]
    public void Decide_own_driver_takes_over_where_it_is_needed()
    {
        Handover handover = new();
        Assert.False(handover.Decide(Seen(InLane(0), InLane(0)), needsOwnDriver: true));
        Assert.True(handover.Decide(Seen(InLane(0), InLane(0)), needsOwnDriver: false));
    }

    [Theory]
    [InlineData(-2.7)]
    [InlineData(0.6)]
    public void Decide_own_driver_takes_over_where_lanes_shift(double shift)
    {
        Handover handover = new();
        Assert.False(handover.Decide(Seen(InLane(0), InLane(shift)), needsOwnDriver: false));
        Assert.True(handover.Decide(Seen(InLane(0), InLane(0)), needsOwnDriver: false));
    }

    [Fact]
    public void Decide_a_marking_ahead_of_a_car_in_its_lane_is_a_shift() =>
        Assert.False(new Handover().Decide(Seen(InLane(0), LaneIndicators.Unknown), needsOwnDriver: false));

    [Theory]
    [InlineData(5.4, 0.75, true)]
    [InlineData(5.4, 0.85, false)]
    [InlineData(4, 0.55, true)]
    [InlineData(4, 0.65, false)]
    public void Decide_hands_back_near_the_middle_of_the_lane(double width, double offset, bool isHandedBack)
    {
        Handover handover = new();
        handover.Decide(Seen(InLane(0), InLane(0)), needsOwnDriver: true);
        LaneIndicators lanes = InLane(offset, width);
        Assert.Equal(isHandedBack, handover.Decide(Seen(lanes, lanes), needsOwnDriver: false));
    }

    [Theory]
    [InlineData(0.25, true)]
    [InlineData(-0.35, false)]
    public void Decide_hands_back_where_no_sharp_bend_is_ahead(double bend, bool isHandedBack)
    {
        Handover handover = new();
        LaneObservation seen = Seen(InLane(0), InLane(0) with { Angle = Indicator.Of(bend) });
        handover.Decide(seen, needsOwnDriver: true);
        Assert.Equal(isHandedBack, handover.Decide(seen, needsOwnDriver: false));
    }

    [Fact]
    public void Decide_controller_keeps_driving_in_a_sharp_bend() =>
        Assert.True(new Handover().Decide(Seen(InLane(0), InLane(0) with { Angle = Indicator.Of(1) }), needsOwnDriver: false));

    /// <summary>A car in a lane.</summary>
    /// <param name="centre">Middle of the lane, metres to the right of the car.</param>
    /// <param name="width">Its width, metres.</param>
    private static LaneIndicators InLane(double centre, double width = 5.4) =>
        LaneIndicators.Unknown with
        {
            Angle = Indicator.Of(0),
            ToMarkingML = Indicator.Of(centre - (width / 2)),
            ToMarkingMR = Indicator.Of(centre + (width / 2)),
        };

    private static LaneObservation Seen(LaneIndicators here, LaneIndicators there) =>
        new()
        {
            Status = LaneStatus.Known,
            Match = new RoadMatch { Outcome = RoadMatchOutcome.Matched },
            IndicatorsAtCar = here,
            Indicators = there,
        };
}
