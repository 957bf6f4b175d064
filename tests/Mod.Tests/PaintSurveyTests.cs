using System.Text.Json;
using System.Windows.Forms;
using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Mod.Tests.Games;
using Harvester.Play.Surveys.Roads;
using Harvester.Sessions.Imaging;

namespace Harvester.Mod.Tests;

/// <summary>The survey of paint in the street of the tests of harvests, on a road of 140 m.</summary>
public sealed class PaintSurveyTests
{
    /// <summary>Pictures of 42 m, of which the outermost metre does not count, on 140 m of road.</summary>
    private const int Pictures = 4;

    /// <summary>The game draws with numbers of single precision; metres.</summary>
    private const double SinglePrecision = 1e-3;

    private const string Done = "The survey of paint is done: 4 pictures";

    [Fact]
    [Trait("Category", "Heavy")]
    public void Key_photographs_the_road_from_above_and_gives_all_back()
    {
        using ScriptDriver driver = OnRoad();
        Pose home = Car(driver).Pose;
        driver.Press(Keys.End);
        driver.UntilMessage("The survey of paint takes 4 pictures, in about 1 min.");
        driver.UntilMessage(Done);
        driver.WaitForDisk();

        JsonElement[] labels = Labels(driver);
        Assert.Equal(Pictures, labels.Length);
        Assert.All(
            labels,
            label =>
            {
                // 900 rows of 3.5 cm are seen from 31.5 m / 2 / tan 25° = 33.78 m above.
                double[] camera = Numbers(label.GetProperty("camera").GetProperty("position"));
                double[] ego = Numbers(label.GetProperty("ego").GetProperty("position"));
                Assert.Equal(33.776, camera[2] - ego[2], 0.01);
                Assert.Equal(97.375, camera[0], SinglePrecision);
                Assert.Equal(-1, Numbers(label.GetProperty("camera").GetProperty("forward"))[2], SinglePrecision);
                Assert.Equal("clear", label.GetProperty("environment").GetProperty("weather").GetString());
                Assert.StartsWith(
                    "12:00",
                    label.GetProperty("environment").GetProperty("timeOfDay").GetString()!,
                    StringComparison.Ordinal
                );
                Assert.Empty(label.GetProperty("objects").EnumerateArray());
                Assert.Equal(JsonValueKind.String, label.GetProperty("depth").GetProperty("completed").ValueKind);
            }
        );
        AssertGivenBack(driver);
        Assert.Equal(home.Position.X, Car(driver).Pose.Position.X, SinglePrecision);
        Assert.Equal(home.Position.Y, Car(driver).Pose.Position.Y, SinglePrecision);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Vehicles_and_people_are_hidden_in_each_picture()
    {
        var screen = new WatchedScreen();
        using ScriptDriver driver = OnRoad(screen);
        var shown = new List<string>();
        int seen = 0;
        screen.Inner = driver.Screen;
        screen.OnGrab = () =>
        {
            seen += InPicture(driver).Length - 1;
            shown.AddRange(InPicture(driver).Where(entity => !entity.IsHidden).Select(entity => entity.Name));
        };
        driver.Press(Keys.End);
        driver.UntilMessage(Done);

        Assert.Empty(shown);
        Assert.NotEqual(0, seen);
        Assert.Equal((Pictures, 0), (driver.Screen.Grabs, driver.Screen.SpoiltPictures));
        AssertGivenBack(driver);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Survey_that_was_stopped_continues_with_what_is_left()
    {
        using ScriptDriver driver = OnRoad();
        driver.Press(Keys.End);
        driver.Until(() => driver.Game.Texts.Any(text => text.StartsWith("PAINT  2 of 4 pictures", StringComparison.Ordinal)));
        driver.Press(Keys.End);
        driver.WaitForDisk();
        Assert.Contains(
            "ended after 2 of 4 pictures. The next one continues there.",
            driver.Game.Notifications[^1],
            StringComparison.Ordinal
        );
        AssertGivenBack(driver);

        driver.Reload();
        driver.Press(Keys.End);
        driver.UntilMessage("The survey of paint takes 2 pictures, after 2 of earlier surveys");
        driver.UntilMessage("The survey of paint is done: 2 pictures");
        driver.WaitForDisk();
        driver.Press(Keys.End);
        driver.UntilMessage("All roads here are photographed from above");
        Assert.Equal(Pictures, Labels(driver).Length);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Place_without_ground_is_taken_by_the_next_survey()
    {
        using ScriptDriver driver = OnRoad();
        driver.Game.SceneRays = new NoRays();
        driver.Press(Keys.End);
        driver.UntilMessage("The survey of paint took 0 of 4 pictures. At 4 places the ground did not load");
        Assert.Contains(driver.Game.Notifications, message => message.Contains("discarded: 4 groundNotLoaded", StringComparison.Ordinal));
        AssertGivenBack(driver);

        driver.Game.SceneRays = null;
        driver.WaitForDisk();
        driver.Press(Keys.End);
        driver.UntilMessage(Done);
    }

    [Fact]
    public void Survey_without_roads_says_how_to_get_them()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.End);
        driver.UntilMessage("Survey the roads first, or name a road file under [Roads].");
        AssertGivenBack(driver);
    }

    [Fact]
    public void Harvest_in_progress_refuses_a_survey()
    {
        using ScriptDriver driver = OnRoad();
        driver.Press(Keys.J);
        driver.Press(Keys.End);

        Assert.Contains("End the harvest first.", driver.Game.Notifications[^1], StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(Hash.SET_ENTITY_VISIBLE)]
    [InlineData(Hash.SET_ENTITY_COORDS_NO_OFFSET)]
    public void Failing_native_ends_the_survey_and_gives_all_back(Hash broken)
    {
        using ScriptDriver driver = OnRoad();
        driver.Press(Keys.End);
        driver.UntilMessage("The survey of paint takes 4 pictures");
        bool isBroken = true;
        driver.Game.Fault = native => isBroken && native == broken ? new InvalidOperationException("broken") : null;
        driver.UntilMessage("The harvest stopped");
        isBroken = false;
        driver.Tick(5);
        driver.WaitForDisk();

        AssertGivenBack(driver);
    }

    [Theory]
    [InlineData("""{"name":"street","path":[[100,190],[100,290]]}""", "The survey of paint takes 2 pictures")]
    [InlineData("""{"name":"far","x":5000,"y":5000}""", "No road lies here.")]
    [InlineData("""{"name":"any","spread":2}""", "plan.json has no place with a point or a path")]
    [InlineData("""{"name":"wrong","x":"here"}""", "The survey of paint cannot begin: plan.json: ")]
    [InlineData(null, "The survey of paint cannot begin: ")]
    public void Survey_of_a_plan_is_around_its_places(string? place, string message)
    {
        using ScriptDriver driver = OnRoad(ini: "[PaintSurvey]\nAround = Plan\nRange = 10\n[Plan]\nFile = plan.json\n");
        if (place is not null)
        {
            File.WriteAllText(
                Path.Combine(driver.Folder, "plan.json"),
                $$"""
                {"name":"roads","places":[{{place}}],"weathers":["clear"],"hours":["12:00"],"frames":2,
                "cameras":[{"name":"small","width":64,"height":48,"verticalFovDegrees":45}]}
                """
            );
        }

        driver.Press(Keys.End);
        driver.UntilMessage(message);
    }

    [Fact]
    public void Survey_that_the_harvest_key_ends_continues_later()
    {
        using ScriptDriver driver = OnRoad();
        driver.Press(Keys.End);
        driver.UntilMessage("The survey of paint takes 4 pictures");
        driver.Tick(3);
        driver.Press(Keys.J);
        driver.UntilMessage("The survey of paint ended after 0 of 4 pictures. The next one continues there.");
        AssertGivenBack(driver);
    }

    [Fact]
    public void Survey_of_no_plan_says_where_to_name_one()
    {
        using ScriptDriver driver = OnRoad(ini: "[PaintSurvey]\nAround = Plan\n");
        driver.Press(Keys.End);
        driver.UntilMessage("needs a plan: name one as File under [Plan].");
        AssertGivenBack(driver);
    }

    private static ScriptDriver OnRoad(IScreen? screen = null, string ini = "")
    {
        var driver = new ScriptDriver(ini, screen: screen);
        HarvestTests.Street(driver.Game);
        Directory.CreateDirectory(driver.Output);
        RoadSurveyFile.Save(Path.Combine(driver.Output, "roads.csv"), RoadTests.Road());
        return driver;
    }

    /// <summary>The vehicle of the survey, and the entities in the 42 m of road around it.</summary>
    private static GameEntity[] InPicture(ScriptDriver driver) =>
        [
            .. driver
                .Game.Entities.Where(entity => entity.Key != TestGame.Player)
                .Select(entity => entity.Value)
                .Where(entity => Math.Abs(entity.Pose.Position.Y - Car(driver).Pose.Position.Y) < 21),
        ];

    private static GameEntity Car(ScriptDriver driver) => driver.Game.Entities[driver.Game.PlayersVehicle];

    private static JsonElement[] Labels(ScriptDriver driver) =>
        [
            .. Directory
                .GetDirectories(Path.Combine(driver.Output, "paint"))
                .SelectMany(session => File.ReadLines(Path.Combine(session, "labels.jsonl")))
                .Select(line => JsonDocument.Parse(line).RootElement),
        ];

    private static double[] Numbers(JsonElement list) => [.. list.EnumerateArray().Select(number => number.GetDouble())];

    private static void AssertGivenBack(ScriptDriver driver)
    {
        Assert.Equal(TestGame.NoCamera, driver.Game.RenderingCamera);
        Assert.False(driver.Game.IsPaused);
        Assert.Null(driver.Game.KeptWeather);
        Assert.All(driver.Game.Entities.Values, entity => Assert.False(entity.IsHidden));
    }

    /// <summary>A screen that says when it is grabbed.</summary>
    private sealed class WatchedScreen : IScreen
    {
        public TestScreen? Inner { get; set; }

        public Action OnGrab { get; set; } = static () => { };

        public GrabResult Grab(PixelBuffer target)
        {
            OnGrab();
            return Inner!.Grab(target);
        }
    }

    /// <summary>A world that is not loaded.</summary>
    private sealed class NoRays : IRayCaster
    {
        public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => null;
    }
}
