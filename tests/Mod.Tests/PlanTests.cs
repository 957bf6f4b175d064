using System.Globalization;
using System.Text.Json;
using System.Text.RegularExpressions;
using System.Windows.Forms;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.Play.Surveys.Roads;

namespace Harvester.Mod.Tests;

public sealed class PlanTests
{
    public const string Ini = "[Plan]\nFile = plan.json\n";

    /// <summary>A plan of one trial of two frames in the street of the tests of harvests.</summary>
    public const string Text = """
        {"name":"play","places":[{"name":"street","x":100,"y":200,"headingDegrees":0}],"weathers":["foggy"],"hours":["07:30"],"frames":2,
        "cameras":[{"name":"small","width":64,"height":48,"verticalFovDegrees":45}]}
        """;

    private const double MillisecondsOfATick = 50;

    [Fact]
    public void Key_runs_the_plan_into_a_session_per_trial()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        Run(driver);

        string session = Path.Combine(driver.Output, "plans", "play", "trials", "street_foggy_0730_small_001");
        Assert.Equal(2, File.ReadAllLines(Path.Combine(session, "labels.jsonl")).Length);
        Assert.Contains("\"weather\":\"foggy\"", File.ReadAllText(Path.Combine(session, "labels.jsonl")), StringComparison.Ordinal);
        Assert.EndsWith(
            "The plan play is over: 1 trial done, none skipped, in " + Path.Combine(driver.Output, "plans", "play") + ".",
            driver.Game.Notifications[^1],
            StringComparison.Ordinal
        );
        AssertGivenBack(driver.Game);
    }

    [Fact]
    public void Trial_with_a_rig_has_its_views_and_points()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        File.WriteAllText(Path.Combine(driver.Folder, "pair.json"), RigTests.Rig);
        Run(
            driver,
            Text.Replace(
                """{"name":"small","width":64,"height":48,"verticalFovDegrees":45}""",
                """{"name":"pair","rig":"pair.json"}""",
                StringComparison.Ordinal
            )
        );

        string session = Path.Combine(driver.Output, "plans", "play", "trials", "street_foggy_0730_pair_001");
        JsonElement[] labels =
        [
            .. File.ReadAllLines(Path.Combine(session, "labels.jsonl")).Select(line => JsonDocument.Parse(line).RootElement),
        ];
        Assert.Equal(["ahead", "left", "ahead", "left"], labels.Select(label => label.GetProperty("view").GetString()));
        Assert.Equal(70, labels[1].GetProperty("camera").GetProperty("verticalFovDegrees").GetDouble(), 3);
        Assert.Single(labels[0].GetProperty("lidar").EnumerateArray());
        AssertGivenBack(driver.Game);
    }

    [Fact]
    public void Trials_have_the_lanes_of_the_measured_paint()
    {
        using var folder = new TemporaryFolder();
        string roads = Path.Combine(folder.Path, "roads.csv");
        string paint = Path.Combine(folder.Path, "paint.csv");
        RoadSurveyFile.Save(roads, RoadTests.Road());
        File.WriteAllText(
            paint,
            "harvester paint,1\nlink,0,97.375,180.125,0,97.375,320.125,0,0,140\nline,0,0,140,0,0,solid,yellow,0.15,,,,0.02,3\n"
                + "line,0,0,140,4.25,4.25,solid,white,0.15,,,,0.02,3\nend,1,2\n"
        );
        using var driver = new ScriptDriver($"{Ini}[Roads]\nFile = {roads}\nPaint = {paint}\n");
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        driver.Until(() => driver.Game.Rectangles.Count > 0);
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        Run(driver);

        string session = Path.Combine(driver.Output, "plans", "play", "trials", "street_foggy_0730_small_001");
        string[] labels = File.ReadAllLines(Path.Combine(session, "labels.jsonl"));
        Assert.Equal(2, labels.Length);
        Assert.All(labels, label => Assert.Contains("\"laneWidthSource\":\"paint\"", label, StringComparison.Ordinal));
        Assert.All(labels, label => Assert.Contains("\"source\":\"paint\",\"sigmaMetres\":0.02", label, StringComparison.Ordinal));
        Assert.Contains("\"paint\": \"paint.csv\"", File.ReadAllText(Path.Combine(session, "session.json")), StringComparison.Ordinal);
    }

    [Fact]
    public void Start_of_a_plan_states_how_much_driving_is_left()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        Run(driver);

        // Two frames at the plan's 10 a second.
        Assert.Contains(
            driver.Game.Notifications,
            message =>
                message.Contains(
                    "The plan has 1 trial left, 0 minutes of driving. How long a minute of driving takes is shown once it is measured.",
                    StringComparison.Ordinal
                )
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Start_of_a_plan_states_how_long_it_takes_once_measured()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Until(() =>
        {
            driver.Clock.Milliseconds += MillisecondsOfATick;
            return driver.Game.Texts.Any(text => text.Contains("minute of driving", StringComparison.Ordinal));
        });
        driver.Press(Keys.J);
        Run(driver, Text.Replace("\"frames\":2", "\"frames\":2,\"hz\":0.02", StringComparison.Ordinal));

        string message = Assert.Single(driver.Game.Notifications, shown => shown.Contains("The plan has", StringComparison.Ordinal));
        Match figures = Regex.Match(
            message,
            "left, 1.7 minutes of driving. 1 minute of driving takes ([0-9.]+), so that they take about ([0-9.]+) minutes"
        );
        Assert.True(figures.Success, message);
        Assert.Equal(100.0 / 60 * Number(1), Number(2), 0.2);

        double Number(int group) => double.Parse(figures.Groups[group].Value, CultureInfo.InvariantCulture);
    }

    [Fact]
    public void Plan_can_start_without_the_key()
    {
        using var driver = new ScriptDriver(Ini + "Start = On\n");
        HarvestTests.Street(driver.Game);
        File.WriteAllText(Path.Combine(driver.Folder, "plan.json"), Text);
        Until(
            driver,
            () =>
                driver.Game.Notifications.Any(message => message.Contains("The plan play is over: 1 trial done", StringComparison.Ordinal))
        );

        Assert.Contains(driver.Game.Vehicles, vehicle => vehicle.Repairs == 1);
    }

    [Fact]
    public void Player_on_foot_is_given_a_car_which_the_end_removes()
    {
        TestGame game;
        using (var driver = new ScriptDriver(Ini))
        {
            game = driver.Game;
            (game.IsInCutScene, game.WantedLevel) = (true, 2);
            Run(driver);

            Assert.Equal((false, 0), (game.IsInCutScene, game.WantedLevel));
            Assert.Equal(TestGame.Adder, Assert.Single(game.Vehicles).Name);
            Assert.Contains("1 trial done", game.Notifications[^1], StringComparison.Ordinal);
        }

        Assert.Empty(game.LeftBehind);
    }

    [Fact]
    public void Reloaded_mod_has_nothing_left_to_do()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        Run(driver);
        driver.Reload();
        driver.Game.Notifications.Clear();
        Run(driver);

        Assert.Contains("1 trial done", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.Single(File.ReadAllLines(Path.Combine(driver.Output, "plans", "play", "plan-status.jsonl")));
    }

    [Fact]
    public void Harvest_of_the_player_goes_on_when_a_trial_cannot_begin()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        Start(driver);
        driver.Press(Keys.J);
        Until(
            driver,
            () => driver.Game.Notifications.Any(message => message.Contains("Another harvest is running", StringComparison.Ordinal))
        );
        driver.Press(Keys.Decimal);
        driver.Game.Notifications.Clear();
        driver.Press(Keys.J);

        Assert.Contains(driver.Game.Notifications, message => message.Contains("The harvest ended: ", StringComparison.Ordinal));
        Assert.False(Directory.Exists(Path.Combine(driver.Output, "plans", "play", "trials", "street_foggy_0730_small_001")));
    }

    [Fact]
    public void Trial_whose_last_frame_is_not_written_is_repeated()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        string folder = Path.Combine(driver.Output, "plans", "play");
        Start(driver);
        Until(
            driver,
            () =>
            {
                // A folder in place of the last image, as soon as the session is open.
                driver.WaitForDisk();
                string session = Path.Combine(folder, "trials", "street_foggy_0730_small_001");
                return Directory.Exists(session)
                    && Directory.CreateDirectory(Path.Combine(session, "frames", "00000001.png", "inner")).Exists;
            }
        );
        Until(driver, () => driver.Game.Notifications.Any(message => message.Contains("The plan play is over", StringComparison.Ordinal)));
        driver.WaitForDisk();

        string[] status = File.ReadAllLines(Path.Combine(folder, "plan-status.jsonl"));
        Assert.Equal(2, status.Length);
        Assert.Contains("\"state\":\"failed\",\"attempt\":1", status[0], StringComparison.Ordinal);
        Assert.Contains("cannot be written", status[0], StringComparison.Ordinal);
        Assert.Contains("\"state\":\"done\",\"attempt\":2,\"frames\":2", status[1], StringComparison.Ordinal);
    }

    [Fact]
    public void Script_that_ends_in_a_trial_gives_everything_back()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        Start(driver);
        Until(driver, () => driver.Game.IsDrivenByTask);
        driver.Script.RaiseAborted();

        AssertGivenBack(driver.Game);
        Assert.Empty(driver.Game.LeftBehind);
    }

    /// <summary>Runs the plan to its end, or until a message says that it cannot be run.</summary>
    internal static void Run(ScriptDriver driver, string plan = Text)
    {
        int before = driver.Game.Notifications.Count;
        Start(driver, plan);
        Until(
            driver,
            () =>
                driver
                    .Game.Notifications.Skip(before)
                    .Any(message =>
                        message.Contains("The plan play is over", StringComparison.Ordinal)
                        || message.Contains(" failed: ", StringComparison.Ordinal)
                        || message.Contains(" stopped: ", StringComparison.Ordinal)
                        || message.Contains("cannot run", StringComparison.Ordinal)
                    )
        );
        driver.WaitForDisk();
    }

    private static void Start(ScriptDriver driver, string plan = Text)
    {
        File.WriteAllText(Path.Combine(driver.Folder, "plan.json"), plan);
        driver.Press(Keys.Decimal);
    }

    private static void Until(ScriptDriver driver, Func<bool> isSo) =>
        driver.Until(() =>
        {
            driver.Clock.Milliseconds += MillisecondsOfATick;
            return isSo();
        });

    private static void AssertGivenBack(TestGame game)
    {
        Assert.Equal(
            (false, false, false, false, (string?)null),
            (game.IsSceneHeld, game.IsPlayerInvincible, game.IsIgnoredByPolice, game.IsDrivenByTask, game.KeptWeather)
        );
        Assert.Equal(TestGame.NoCamera, game.RenderingCamera);
        Assert.DoesNotContain(game.Vehicles, vehicle => vehicle.IsFrozen);
    }
}
