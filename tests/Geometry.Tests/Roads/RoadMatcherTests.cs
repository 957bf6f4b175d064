using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Roads;

public sealed class RoadMatcherTests
{
    private const double North = 0;
    private const double East = 270;
    private const double South = 180;

    [Theory]
    // Two-way road to the north, 2 lanes and 1: forward lanes at 0 to 5.4 and 5.4 to 10.8 m to the right (east).
    [InlineData(2.7, North, true, 0, 0)]
    [InlineData(9.1, North, true, 1, 1)]
    // Southwards, the one lane lies to the west; a car 2 m west of the line is 0.7 m left of its middle.
    [InlineData(-2, South, false, 0, -0.7)]
    public void Match_two_way_road_gives_direction_lane_and_offset(double x, double heading, bool isForward, int lane, double fromCentre)
    {
        RoadMatch match = Matcher(Road(2, 1, null, (0, 0), (0, 50), (0, 100))).Match(new Vector3D(x, 30, 0), heading);

        Assert.Equal(RoadMatchOutcome.Matched, match.Outcome);
        Assert.Equal((0, isForward, lane), (match.Link, match.IsForward, match.Lane));
        Assert.Equal(fromCentre, match.OffsetFromLaneCentre!.Value, 9);
        Assert.Equal(0, match.HeadingError, 9);
        Assert.False(match.InJunction);
        Assert.InRange(match.Confidence, 0.99, 1);
    }

    [Fact]
    public void Match_median_moves_the_lanes_outwards()
    {
        // The left edge lies half of 4 m right of the line: 2.0; a car at 4.7 is in the middle of lane 0.
        RoadMatch match = Matcher(Road(1, 1, 4, (0, 0), (0, 100))).Match(new Vector3D(4.7, 50, 0), North);

        Assert.Equal(2, match.LeftEdge, 9);
        Assert.Equal(0, match.OffsetFromLaneCentre!.Value, 9);
    }

    [Fact]
    public void Match_heading_error_is_positive_when_pointing_right()
    {
        // 5 degrees clockwise of north is heading 355.
        RoadMatch match = Matcher(Road(1, 1, null, (0, 0), (0, 100))).Match(new Vector3D(2.7, 50, 0), 355);

        Assert.Equal(Angles.ToRadians(5), match.HeadingError, 9);
    }

    [Fact]
    public void Match_of_a_reversed_one_way_link_is_centred_along_travel()
    {
        // Held from north to south but driven northwards, two lanes: 5.4 m either side of the line.
        RoadMatcher matcher = Matcher(Road(0, 2, null, (0, 100), (0, 0)));

        RoadMatch match = matcher.Match(new Vector3D(-3, 50, 0), North);
        Assert.Equal((false, (int?)0), (match.IsForward, match.Lane));
        Assert.Equal(1, matcher.Match(new Vector3D(3, 50, 0), North).Lane);
        Assert.Equal(RoadMatchOutcome.NotAlongAnyRoad, matcher.Match(new Vector3D(3, 50, 0), South).Outcome);
    }

    [Theory]
    [InlineData(60, 50, 0, North, RoadMatchOutcome.NoRoadNear)]
    [InlineData(2.7, 50, 12, North, RoadMatchOutcome.NoRoadNear)]
    [InlineData(5000, 5000, 0, North, RoadMatchOutcome.NoRoadNear)]
    [InlineData(2.7, 50, 0, East, RoadMatchOutcome.NotAlongAnyRoad)]
    [InlineData(-2.8, 50, 0, North, RoadMatchOutcome.BesideTheLanes)]
    [InlineData(8.2, 50, 0, North, RoadMatchOutcome.BesideTheLanes)]
    public void Match_reports_why_it_has_no_result(double x, double y, double z, double heading, RoadMatchOutcome expected) =>
        Assert.Equal(expected, Matcher(Road(1, 1, null, (0, 0), (0, 100))).Match(new Vector3D(x, y, z), heading).Outcome);

    [Fact]
    public void Match_on_crossing_bridges_uses_height()
    {
        var network = new RoadNetwork(
            [Node(0, 0, 0), Node(0, 100, 0), Node(-50, 0, 6), Node(50, 100, 6)],
            [new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None), new RoadLink(2, 3, 1, 1, null, RoadLinkFlags.None)]
        );
        RoadMatcher matcher = Matcher(network);

        // The upper road crosses to the north-east (heading 315); a heading between the two leaves only the height to go by.
        const double between = 337.5;
        Assert.Equal(0, matcher.Match(new Vector3D(2, 49, 0.4), between).Link);
        Assert.Equal(1, matcher.Match(new Vector3D(2, 49, 6.4), between).Link);
    }

    [Fact]
    public void Match_between_two_roads_is_ambiguous_until_one_is_followed()
    {
        // Two one-way roads whose lanes overlap between x = 2 and x = 2.7, and a car exactly between them.
        var network = new RoadNetwork(
            [Node(0, 0, 0), Node(0, 100, 0), Node(4.7, 0, 0), Node(4.7, 100, 0)],
            [new RoadLink(0, 1, 1, 0, null, RoadLinkFlags.None), new RoadLink(2, 3, 1, 0, null, RoadLinkFlags.None)]
        );
        RoadMatcher matcher = Matcher(network);
        var between = new Vector3D(2.35, 50, 0);

        Assert.Equal(RoadMatchOutcome.Ambiguous, matcher.Match(between, North).Outcome);
        foreach ((double x, int link) in new[] { (0.0, 0), (4.7, 1) })
        {
            RoadMatch followed = matcher.Match(new Vector3D(x, 45, 0), North);
            RoadMatch match = matcher.Match(between, North, followed);
            Assert.Equal((RoadMatchOutcome.Matched, link), (match.Outcome, match.Link));
        }
    }

    [Fact]
    public void Match_prefers_a_slip_lane_only_when_it_fits_better()
    {
        RoadNode Slip(double x, double y) => Node(x, y, 0) with { Flags = RoadNodeFlags.SlipLane };
        var network = new RoadNetwork(
            [Node(0, 0, 0), Node(0, 100, 0), Slip(4.7, 0), Slip(4.7, 100)],
            [new RoadLink(0, 1, 1, 0, null, RoadLinkFlags.None), new RoadLink(2, 3, 1, 0, null, RoadLinkFlags.None)]
        );
        RoadMatcher matcher = Matcher(network);

        Assert.Equal(0, matcher.Match(new Vector3D(2.35, 50, 0), North).Link);
        Assert.Equal(1, matcher.Match(new Vector3D(4.7, 50, 0), North).Link);
    }

    [Fact]
    public void Match_in_a_crossing_is_a_junction_up_to_its_corners()
    {
        var network = new RoadNetwork(
            [Node(0, 0, 0), Node(0, 50, 0), Node(0, 100, 0), Node(50, 50, 0)],
            [
                new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None),
                new RoadLink(1, 2, 1, 1, null, RoadLinkFlags.None),
                new RoadLink(1, 3, 1, 1, null, RoadLinkFlags.None),
            ]
        );
        RoadMatcher matcher = Matcher(network);

        // The road that joins at y = 50 is 5.4 m wide on either side, and its corners take 1.5 m.
        Assert.True(matcher.Match(new Vector3D(2.7, 43.2, 0), North).InJunction);
        Assert.True(matcher.Match(new Vector3D(2.7, 56.8, 0), North).InJunction);
        Assert.False(matcher.Match(new Vector3D(2.7, 43, 0), North).InJunction);
        Assert.False(matcher.Match(new Vector3D(2.7, 57, 0), North).InJunction);
    }

    [Fact]
    public void Match_of_a_car_between_two_carriageways_is_in_a_junction()
    {
        // A link at 45 degrees ties two one-way roads; from its start on, a car along it is no longer in the lanes of either.
        var network = new RoadNetwork(
            [Node(0, 0, 0), Node(0, 50, 0), Node(0, 100, 0), Node(14, 0, 0), Node(14, 64, 0), Node(14, 100, 0)],
            [
                new RoadLink(0, 1, 1, 0, null, RoadLinkFlags.None),
                new RoadLink(1, 2, 1, 0, null, RoadLinkFlags.None),
                new RoadLink(3, 4, 1, 0, null, RoadLinkFlags.None),
                new RoadLink(4, 5, 1, 0, null, RoadLinkFlags.None),
                new RoadLink(1, 4, 1, 1, null, RoadLinkFlags.None),
            ]
        );
        RoadMatcher matcher = Matcher(network);
        RoadMatch before = matcher.Match(new Vector3D(0, 48, 0), North);

        Assert.False(before.InJunction);
        Assert.False(matcher.Match(new Vector3D(0, 52, 0), North, before).InJunction);
        Assert.True(matcher.Match(new Vector3D(3, 52, 0), North - 45, before).InJunction);
    }

    [Fact]
    public void Match_never_uses_links_that_cars_do_not_drive()
    {
        foreach (
            (RoadLinkFlags link, RoadNodeFlags node) in new[]
            {
                (RoadLinkFlags.Shortcut, RoadNodeFlags.None),
                (RoadLinkFlags.DontUseForNavigation, RoadNodeFlags.None),
                (RoadLinkFlags.None, RoadNodeFlags.PedestrianCrossing),
                (RoadLinkFlags.None, RoadNodeFlags.Water),
            }
        )
        {
            var network = new RoadNetwork([Node(0, 0, 0) with { Flags = node }, Node(0, 100, 0)], [new RoadLink(0, 1, 1, 1, null, link)]);
            Assert.Equal(RoadMatchOutcome.NoRoadNear, Matcher(network).Match(new Vector3D(2.7, 50, 0), North).Outcome);
        }
    }

    [Fact]
    public void Match_of_a_position_that_is_not_finite_is_refused() =>
        Assert.Throws<ArgumentOutOfRangeException>(() =>
            Matcher(Road(1, 1, null, (0, 0), (0, 100))).Match(new Vector3D(double.NaN, 0, 0), North)
        );

    private static RoadMatcher Matcher(RoadNetwork network) => new(new RoadCurves(network), new LaneModel(network));

    private static RoadNode Node(double x, double y, double z) => new(0, 0, new Vector3D(x, y, z), "", RoadNodeFlags.None);

    private static RoadNetwork Road(int forward, int backward, double? median, params (double X, double Y)[] points) =>
        new(
            [.. points.Select(point => Node(point.X, point.Y, 0))],
            [.. Enumerable.Range(0, points.Length - 1).Select(i => new RoadLink(i, i + 1, forward, backward, median, RoadLinkFlags.None))]
        );
}
