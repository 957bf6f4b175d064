using System.Windows.Forms;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Play.Surveys.Roads;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests;

public sealed class RoadTests
{
    /// <summary>The game draws with numbers of single precision; metres.</summary>
    private const double SinglePrecision = 1e-3;

    [Fact]
    public void Key_surveys_the_nearby_roads_and_the_next_survey_resumes()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Game.Roads = new FakeRoadSource(Road());
        driver.Press(Keys.U);
        driver.Until(() => driver.Game.Texts.Any(text => text.StartsWith("SURVEY  2 nodes  1 links  0 waiting", StringComparison.Ordinal)));
        driver.Press(Keys.U);
        driver.WaitForDisk();
        string file = Path.Combine(driver.Output, "roads.csv");
        Assert.Contains($"The road survey is off: 2 nodes and 1 link, in {file}", driver.Game.Notifications[^1], StringComparison.Ordinal);
        RoadNetwork found = RoadSurveyFile.Load(file)!;
        Assert.Equal(Road().Nodes.Select(node => node.Position), found.Nodes.Select(node => node.Position));
        RoadLink link = Assert.Single(found.Links);
        Assert.Equal((1, 2), (link.LanesForward, link.LanesBackward));

        driver.Game.Roads = null;
        driver.Reload();
        driver.Press(Keys.U);
        driver.Until(() => driver.Game.Texts.Any(text => text.StartsWith("SURVEY  2 nodes  1 links", StringComparison.Ordinal)));
    }

    [Fact]
    public void Damaged_survey_is_reported_and_left_unchanged()
    {
        using var driver = new ScriptDriver();
        string file = Path.Combine(driver.Output, "roads.csv");
        Directory.CreateDirectory(driver.Output);
        File.WriteAllText(file, "my notes\n");
        driver.Game.Roads = new FakeRoadSource(Road());
        driver.Press(Keys.U);
        driver.Until(() => driver.Game.Notifications.Any(text => text.Contains("The road survey failed", StringComparison.Ordinal)));
        driver.Tick(10);
        driver.WaitForDisk();

        Assert.Equal("my notes\n", File.ReadAllText(file));
    }

    [Fact]
    public void Overlay_draws_the_lane_lines_of_the_surveyed_road()
    {
        using var driver = new ScriptDriver("[Harvest]\nClasses = Bus\n");
        HarvestTests.Street(driver.Game);
        driver.Game.Roads = new FakeRoadSource(Road());
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        driver.Until(() => driver.Game.Rectangles.Count > 0);

        AssertLinesOfTheRoad(driver.Game.Rectangles);
    }

    [Fact]
    public void Lanes_have_the_width_measured_from_the_games_edges()
    {
        using var driver = new ScriptDriver("[Harvest]\nClasses = Bus\n");
        HarvestTests.Street(driver.Game);
        driver.Game.Roads = new FakeRoadSource(Road()) { LaneWidth = 4.5 };
        driver.Press(Keys.U);
        driver.Until(() => driver.Game.Texts.Any(text => text.StartsWith("SURVEY  2 nodes  1 links  0 waiting", StringComparison.Ordinal)));
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        driver.Clock.Milliseconds += 6_000;
        driver.Until(() => Places(driver.Game.Rectangles).Any(place => Math.Abs(place - (97.375 + 4.5)) < SinglePrecision));
        AssertLinesOfTheRoad(driver.Game.Rectangles, laneWidth: 4.5);
        driver.Press(Keys.K);
        driver.Tick(20);
        driver.WaitForDisk();

        Assert.Contains(
            "\"laneWidthMetres\":4.5,\"laneWidthSource\":\"calibrated\"",
            Assert.Single(driver.Labels()).Replace(" ", string.Empty, StringComparison.Ordinal),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Lanes_from_the_players_file_need_no_query_of_the_game()
    {
        using var folder = new TemporaryFolder();
        string file = Path.Combine(folder.Path, "mine.csv");
        RoadSurveyFile.Save(file, Road());
        using var driver = new ScriptDriver($"[Roads]\nFile = {file}\nNarrowLaneWidth = 3.5\n[Harvest]\nClasses = Bus\n");
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        driver.Until(() => driver.Game.Rectangles.Count > 0);
        AssertLinesOfTheRoad(driver.Game.Rectangles);
        driver.Press(Keys.K);
        driver.Tick(20);
        driver.WaitForDisk();

        string header = File.ReadAllText(Assert.Single(Directory.GetFiles(driver.Folder, "session.json", SearchOption.AllDirectories)));
        Assert.Contains("\"laneWidth\": \"5.4\",\n    \"narrowLaneWidth\": \"3.5\"", header, StringComparison.Ordinal);
        Assert.Contains(
            "\"source\":\"roadFile\"",
            Assert.Single(driver.Labels()).Replace(" ", string.Empty, StringComparison.Ordinal),
            StringComparison.Ordinal
        );
        Assert.DoesNotContain(GTA.Native.Hash.GET_CLOSEST_ROAD, driver.Game.Calls);
    }

    [Fact]
    public void Unreadable_road_file_is_reported_with_its_line()
    {
        using var folder = new TemporaryFolder();
        string file = Path.Combine(folder.Path, "mine.csv");
        File.WriteAllText(file, "not roads\n");
        using var driver = new ScriptDriver($"[Roads]\nFile = {file}\n");
        HarvestTests.Street(driver.Game);
        driver.Until(() => driver.Game.Notifications.Any(text => text.Contains("Reading the roads failed", StringComparison.Ordinal)));
        driver.Press(Keys.K);
        driver.Tick(20);
        driver.WaitForDisk();

        Assert.Single(driver.Labels());
        Assert.Equal(1, driver.Game.Notifications.Count(text => text.Contains("Reading the roads", StringComparison.Ordinal)));
    }

    /// <summary>
    /// A road to the north, 2.625 m left of the player's car, with a lane along and two lanes back. Its nodes lie in the middle of the
    /// game's grid, a quarter of a metre wide, so that nothing is lost when the game truncates them.
    /// </summary>
    internal static RoadNetwork Road() => new([NodeAt(180.125, 0), NodeAt(320.125, 1)], [new RoadLink(0, 1, 1, 2, 0, RoadLinkFlags.None)]);

    private static RoadNode NodeAt(double north, int number) =>
        new(7, number, new Vector3D(97.375, north, 0), string.Empty, RoadNodeFlags.None);

    private static void AssertLinesOfTheRoad(IEnumerable<Box2D> dots, double laneWidth = 5.4)
    {
        double[] places = Places(dots);
        double[] lines = [97.375 + laneWidth, 97.375, 97.375 - laneWidth, 97.375 - (2 * laneWidth)];
        Assert.All(places, place => Assert.Contains(lines, line => Math.Abs(line - place) < SinglePrecision));
        Assert.All(lines, line => Assert.InRange(places.Count(place => Math.Abs(line - place) < SinglePrecision), 10, 40));
    }

    /// <summary>
    /// How far east the dots are on the road. The camera is at x = 100 and 1 m above it. A point at x, d m ahead, is drawn at
    /// u = 1/2 + (x - 100) / (2 d tan 25° · 4/3) and v = 1/2 + 1 / (2 d tan 25°): (u - 1/2) / (v - 1/2) tells x without d.
    /// </summary>
    private static double[] Places(IEnumerable<Box2D> dots) =>
        [
            .. dots.Select(dot => new Vector2D((dot.XMin + dot.XMax) / 2, (dot.YMin + dot.YMax) / 2))
                .Select(point => 100 + ((point.X - 0.5) / (point.Y - 0.5) * (4.0 / 3))),
        ];
}
