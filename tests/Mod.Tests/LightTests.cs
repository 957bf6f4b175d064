using System.Text.Json;
using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;

namespace Harvester.Mod.Tests;

/// <summary>The three ways to know what a traffic light shows, in a town whose lights work.</summary>
public sealed class LightTests
{
    /// <summary>Ticks go by here as fast as they can and wait for no disk: there is room for every frame.</summary>
    private const string Classes = "Classes = TrafficLight\nQueue = 1000\n";
    private const string Image = "[Harvest]\nWidth = 640\nHeight = 480\nRate = 1\n" + Classes;
    private const string SmallImage = "[Harvest]\nWidth = 160\nHeight = 120\nRate = 5\n" + Classes;
    internal const string TableOfOne = "prop_traffic_03a,,trafficLight,SIGNAL,,0,-0.2,-0.1,3.4,0.2,-0.4,2.4,-y,estimated,test\n";
    private const int MaxPictureLag = 4;
    private const int Ticks = 400;

    /// <summary>
    /// Of the game's time, which stands while a frame is taken: each road has 7 s of green, 2 s of amber and a second of red for both.
    /// </summary>
    private const int LightsCycleMilliseconds = 20_000;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Lights_driven_by_the_mod_match_the_picture_and_are_restored()
    {
        var shown = new Dictionary<long, Dictionary<int, int>>();
        using ScriptDriver driver = InTown(SmallImage + "DriveLights = On\n");
        HarvestFor(driver, Ticks, () => shown[driver.Game.Frame] = new Dictionary<int, int>(driver.Game.LightOverrides));
        Assert.Empty(driver.Game.LightOverrides);

        int set = 0;
        foreach ((long frame, JsonElement light, int entity) in Heads(driver).Where(head => Method(head.Light) == "set"))
        {
            // Whichever of the last frames the picture is of, the light shows what its label says.
            int[] values = [.. Enumerable.Range(0, MaxPictureLag + 1).Select(ago => shown[frame - ago][entity])];
            string[] names = ["green", "red", "amber"];
            Assert.All(values, value => Assert.Equal(names[value], State(light)));
            set++;
        }

        Assert.InRange(set, 20, int.MaxValue);
        Assert.Contains(shown.Values.SelectMany(lights => lights.Values), value => value == 0);
        Assert.Contains(shown.Values.SelectMany(lights => lights.Values), value => value == 1);
    }

    [Fact]
    public void Lights_driven_by_the_game_are_read_from_pixels_or_unknown()
    {
        using ScriptDriver driver = InTown(Image);
        HarvestFor(driver, Ticks, () => { });

        (long Frame, JsonElement Light, int Entity)[] heads = [.. Heads(driver)];
        Assert.Contains(heads, head => Method(head.Light) == "observed" && head.Light.GetProperty("litFraction").GetDouble() > 0);
        Assert.Contains(heads, head => Method(head.Light) == "unknown" && State(head.Light) == "unknown");
        Assert.DoesNotContain(heads, head => Method(head.Light) == "set");
        Assert.DoesNotContain(Hash.SET_ENTITY_TRAFFICLIGHT_OVERRIDE, driver.Game.Calls);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Pictures_show_the_lamps_that_the_mod_has_set()
    {
        // The mod sets the lights and its record is not used: the state read from the picture must be the one that was set.
        var scene = new SimulatedScene(Town(), ModelFaces.Table);
        using var driver = new ScriptDriver(Image, scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock, Table());
        foreach (
            int light in driver
                .Game.Entities.Where(entity => entity.Value.Name.StartsWith("prop_traffic", StringComparison.Ordinal))
                .Select(entity => entity.Key)
        )
        {
            driver.Game.LightDriven(light, 1);
        }

        HarvestFor(driver, Ticks, () => { });
        string[] states = [.. Heads(driver).Where(head => Method(head.Light) == "observed").Select(head => State(head.Light))];
        Assert.InRange(states.Length, 3, int.MaxValue);
        Assert.All(states, state => Assert.Equal("red", state));
    }

    [Fact]
    public void Crossing_roads_alternate_in_the_other_order_of_numbers()
    {
        using ScriptDriver driver = OnStreet(
            "[Harvest]\nWidth = 160\nHeight = 120\nRate = 1\nQueue = 1000\nDriveLights = On\nLightOrder = RedAmberGreen\n",
            out int along,
            out int across
        );
        driver.Press(Keys.J);
        var seen = new HashSet<(int, int)>();
        int begun = driver.Game.TimerMilliseconds;
        driver.Until(() =>
        {
            if (driver.Game.LightOverrides.Count == 2)
            {
                seen.Add((driver.Game.LightOverrides[along], driver.Game.LightOverrides[across]));
            }

            return driver.Game.TimerMilliseconds - begun > LightsCycleMilliseconds;
        });

        // 0 is red, 1 amber, 2 green; one of the two is always red, and both are for a second.
        Assert.Equal([(0, 0), (0, 1), (0, 2), (1, 0), (2, 0)], seen.Order());
    }

    [Fact]
    public void Lights_are_restored_on_abort_even_if_one_no_longer_exists()
    {
        using ScriptDriver driver = OnStreet("[Harvest]\nDriveLights = On\n", out int along, out int across);
        driver.Press(Keys.J);
        driver.Tick(30);
        Assert.Equal([along, across], driver.Game.LightOverrides.Keys.Order());
        driver.Game.Entities.Remove(along);
        var other = new Thread(driver.Script.RaiseAborted);
        other.Start();
        other.Join();

        Assert.Equal([along], driver.Game.LightOverrides.Keys);
        Assert.DoesNotContain(driver.Game.Notifications, message => message.Contains("failed", StringComparison.Ordinal));
    }

    [Fact]
    public void Light_out_of_range_is_restored()
    {
        using ScriptDriver driver = OnStreet("[Harvest]\nDriveLights = On\n", out int along, out int across);
        driver.Press(Keys.J);
        driver.Tick(30);
        GameEntity light = driver.Game.Entities[along];
        light.Pose = light.Pose with { Position = new Vector3D(5_000, 0, 0) };
        driver.Tick(300);

        Assert.Equal([across], driver.Game.LightOverrides.Keys);
    }

    [Fact]
    public void Light_that_cannot_be_restored_does_not_affect_others()
    {
        using ScriptDriver driver = OnStreet("[Harvest]\nDriveLights = On\n", out _, out _);
        driver.Press(Keys.J);
        driver.Tick(30);
        int asked = 0;
        driver.Game.Fault = native =>
            native == Hash.SET_ENTITY_TRAFFICLIGHT_OVERRIDE && asked++ == 0 ? new InvalidOperationException("No light.") : null;
        driver.Press(Keys.J);
        driver.Tick(3);

        Assert.Empty(driver.Game.LightOverrides);
        Assert.Contains(
            driver.Game.Notifications,
            message => message.Contains("The driving of traffic lights failed: No light.", StringComparison.Ordinal)
        );
    }

    private static ScriptDriver InTown(string ini)
    {
        var scene = new SimulatedScene(Town(), ModelFaces.Table);
        return new ScriptDriver(ini, scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock, Table());
    }

    /// <summary>The player's car on a street with a light for its own road, and one for the road that crosses.</summary>
    private static ScriptDriver OnStreet(string ini, out int along, out int across)
    {
        var driver = new ScriptDriver(ini, faces: TableOfOne);
        HarvestTests.Street(driver.Game);
        along = driver.Game.Add(LightAt(new Vector3D(104, 230, 0), Axes.Identity));
        across = driver.Game.Add(LightAt(new Vector3D(96, 240, 0), Axes.FromHeading(90)));
        return driver;
    }

    internal static GameEntity LightAt(Vector3D place, Axes axes) =>
        new()
        {
            Pool = PoolKind.Props,
            Name = "prop_traffic_03a",
            Pose = new Pose(place, axes),
        };

    private static SimulationOptions Town() =>
        new()
        {
            Seed = 12,
            TrafficDensity = 0,
            PedestrianDensity = 0,
        };

    private static string Table()
    {
        var text = new StringWriter();
        FaceTableWriter.Write(ModelFaces.Table, text);
        return text.ToString();
    }

    private static void HarvestFor(ScriptDriver driver, int ticks, Action afterTick)
    {
        driver.Script.RaiseKeyUp(Keys.J);
        driver.WaitForDisk();
        for (int tick = 0; tick < ticks; tick++)
        {
            driver.Tick();
            afterTick();
        }

        driver.Script.RaiseKeyUp(Keys.J);
        driver.Tick();
        driver.WaitForDisk();
    }

    /// <summary>The heads of lights in the labels, with the number of the frame and the handle of their props.</summary>
    private static IEnumerable<(long Frame, JsonElement Light, int Entity)> Heads(ScriptDriver driver) =>
        from line in driver.Labels()
        let label = JsonDocument.Parse(line).RootElement
        from item in label.GetProperty("objects").EnumerateArray()
        where item.GetProperty("space").ValueKind == JsonValueKind.Object
        let centre = item.GetProperty("box3d").GetProperty("centre").EnumerateArray().Select(value => value.GetDouble()).ToArray()
        select (
            label.GetProperty("gameFrame").GetInt64(),
            item.GetProperty("space").GetProperty("light"),
            Nearest(driver.Game, new Vector3D(centre[0], centre[1], centre[2]), item.GetProperty("model").GetString()!)
        );

    private static int Nearest(TestGame game, Vector3D head, string model) =>
        game
            .Entities.Where(entity => entity.Value.Name == model)
            .MinBy(entity => ModelFaces.Table.Of(model).Min(face => (face.CuboidAt(entity.Value.Pose).Centre - head).Length))
            .Key;

    private static string State(JsonElement light) => light.GetProperty("state").GetString()!;

    private static string Method(JsonElement light) => light.GetProperty("method").GetString()!;
}
