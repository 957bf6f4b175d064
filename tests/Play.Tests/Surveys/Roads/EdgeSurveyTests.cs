using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Play.Surveys.Roads;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Surveys.Roads;

/// <summary>The lane widths that the survey finds in games that report edges correctly, differently, wrongly or not at all.</summary>
public sealed class EdgeSurveyTests : IDisposable
{
    private const double LaneWidth = 4.6;

    private readonly string _file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());

    public void Dispose() => File.Delete(_file);

    [Fact]
    public void Step_with_edges_of_the_game_finds_every_lane_width()
    {
        RoadNetwork found = Surveyed(new FakeRoadSource(Street()) { LaneWidth = LaneWidth });

        AssertCalibrated(found);
        // Each of 3 links twice at both of its ends.
        Assert.Equal(12, found.Edges.Count);
    }

    [Fact]
    public void Step_with_edges_swapped_by_the_game_finds_the_same_width() =>
        AssertCalibrated(Surveyed(new FakeRoadSource(Street()) { LaneWidth = LaneWidth, ReportedEdge = sides => sides.OnTheLeft }));

    [Fact]
    public void Step_with_mirrored_edges_keeps_the_constant_if_sides_differ()
    {
        LaneModel lanes = new(Surveyed(new FakeRoadSource(Street()) { LaneWidth = LaneWidth, ReportedEdge = sides => sides.Mirrored }));

        // 2 lanes there and 1 back, with 2 m between: 1 + 2 · 4.6 on the side of one lane would be a lane of 9.2 m.
        Assert.Equal((RoadGeometry.LaneWidth, LaneWidthSource.Constant), lanes.WidthOf(0, isForward: true, station: 0));
        // A one-way road has the same on both sides, whether mirrored or not.
        Assert.Equal(LaneWidthSource.Calibrated, lanes.WidthOf(1, isForward: true, station: 0).Source);
    }

    [Fact]
    public void Step_without_edges_from_the_game_keeps_the_constant()
    {
        RoadNetwork found = Surveyed(new FakeRoadSource(Street()) { ReportedEdge = _ => null });

        Assert.Empty(found.Edges);
        AssertConstant(found);
    }

    [Fact]
    public void Step_with_edges_always_on_one_side_keeps_the_constant() =>
        AssertConstant(Surveyed(new FakeRoadSource(Street()) { ReportedEdge = sides => sides.Node + new Vector3D(LaneWidth, 0, 0) }));

    [Fact]
    public void Step_with_inconsistent_edges_keeps_the_constant()
    {
        int asked = 0;
        AssertConstant(
            Surveyed(
                new FakeRoadSource(Street())
                {
                    ReportedEdge = sides => sides.Node + (sides.Right * (sides.ToTheRight + (asked++ / 6 * 0.5))),
                }
            )
        );
    }

    [Fact]
    public void Step_with_implausible_lane_widths_keeps_the_constant() =>
        AssertConstant(Surveyed(new FakeRoadSource(Street()) { LaneWidth = 7.5 }));

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Step_with_random_edge_points_keeps_the_constant(int seed)
    {
        var random = new Random(seed);
        double[] scales = [1, 10, 1e4, 1e12, double.NaN, double.PositiveInfinity];
        Vector3D Any(RoadSides sides)
        {
            double scale = scales[random.Next(scales.Length)];
            return sides.Node
                + new Vector3D(
                    (random.NextDouble() - 0.5) * scale,
                    (random.NextDouble() - 0.5) * scale,
                    (random.NextDouble() - 0.5) * scale
                );
        }

        RoadNetwork found = Surveyed(new FakeRoadSource(Street()) { ReportedEdge = sides => Any(sides) });
        RoadSurveyFile.Save(_file, found);

        AssertConstant(RoadSurveyFile.Load(_file)!);
    }

    [Fact]
    public void Step_with_an_earlier_survey_queries_only_missing_edges()
    {
        int asked = 0;
        FakeRoadSource Game() =>
            new(Street())
            {
                LaneWidth = LaneWidth,
                ReportedEdge = sides =>
                {
                    asked++;
                    return sides.OnTheRight;
                },
            };
        RoadNetwork first = Surveyed(Game());
        Assert.Equal(12, asked);
        RoadSurveyFile.Save(_file, first);
        Surveyed(Game(), RoadSurveyFile.Load(_file));
        Assert.Equal(12, asked);

        // The edges of link 2 lack: two rounds at its two ends.
        RoadNetwork part = new(first.Nodes, first.Links, [.. first.Edges.Where(edge => edge.Link != 2)]);
        RoadNetwork whole = Surveyed(Game(), part);
        Assert.Equal(16, asked);
        AssertCalibrated(whole);
    }

    [Fact]
    public void Step_queries_the_same_edges_again_in_another_tick()
    {
        int tick = 0;
        var ticks = new List<(Vector3D, int)>();
        var survey = new RoadSurvey(
            new FakeRoadSource(Street())
            {
                ReportedEdge = sides =>
                {
                    ticks.Add((sides.OnTheRight, tick));
                    return sides.OnTheRight;
                },
            }
        );
        for (; tick < 20; tick++)
        {
            survey.Step(Place);
        }

        Assert.All(ticks.GroupBy(asked => asked.Item1), asked => Assert.Equal(2, asked.Select(one => one.Item2).Distinct().Count()));
    }

    [Fact]
    public void Step_on_a_drive_queries_edges_of_links_first_seen_from_afar()
    {
        var survey = new RoadSurvey(new FakeRoadSource(Street()) { LaneWidth = LaneWidth });
        // From here the game knows the nodes at 840 and 860 m; the one at 820 m is an end of a link that is met, but 155 m away.
        Vector3D far = new(-400, 975, 5);
        for (int i = 0; i < 20; i++)
        {
            survey.Step(far);
        }

        Assert.Equal(2, survey.ToNetwork().Links.Count);
        Assert.Equal(4, survey.ToNetwork().Edges.Count);
        for (int i = 0; i < 20; i++)
        {
            survey.Step(Place);
        }

        AssertCalibrated(survey.ToNetwork());
    }

    private static Vector3D Place => new(-400, 830, 5);

    private static RoadNetwork Surveyed(FakeRoadSource game, RoadNetwork? earlier = null)
    {
        var survey = new RoadSurvey(game, earlier);
        for (int i = 0; i < 20; i++)
        {
            survey.Step(Place);
        }

        RoadNetwork found = survey.ToNetwork();
        Assert.Equal(3, found.Links.Count);
        return found;
    }

    private static void AssertCalibrated(RoadNetwork found)
    {
        var lanes = new LaneModel(found);
        const double rounding = 1e-9;
        Assert.All(
            Enumerable.Range(0, 3),
            link =>
            {
                (double width, LaneWidthSource source) = lanes.WidthOf(link, isForward: true, station: 0);
                Assert.Equal(LaneWidthSource.Calibrated, source);
                Assert.Equal(LaneWidth, width, rounding);
            }
        );
    }

    private static void AssertConstant(RoadNetwork found) =>
        Assert.All(
            Enumerable.Range(0, 3),
            link =>
                Assert.Equal(
                    (RoadGeometry.LaneWidth, LaneWidthSource.Constant),
                    new LaneModel(found).WidthOf(link, isForward: true, station: 0)
                )
        );

    /// <summary>
    /// A street of three links in a slight bend: two lanes there and one back about a median, three lanes one-way, one lane each way.
    /// </summary>
    private static RoadNetwork Street() =>
        new(
            [Node(0, -400, 800), Node(1, -401, 820), Node(2, -404, 840), Node(3, -409, 860)],
            [
                new RoadLink(0, 1, 2, 1, 2, RoadLinkFlags.None),
                new RoadLink(1, 2, 3, 0, null, RoadLinkFlags.None),
                new RoadLink(2, 3, 1, 1, 0, RoadLinkFlags.None),
            ]
        );

    private static RoadNode Node(int number, double x, double y) =>
        new(500, number, PathGrid.RemoveBias(new Vector3D(x, y, 5)), "", RoadNodeFlags.None);
}
