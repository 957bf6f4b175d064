using System.Text.Json;
using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>Updates of the game break the API's lists of nearby entities; natives take their place.</summary>
public sealed class BrokenListTests
{
    private const int EnoughTicksForAFrame = 20;

    [Fact]
    public void Lists_that_throw_are_replaced_with_the_same_labels()
    {
        JsonElement[] whole = HarvestWith(null, out _, out JsonElement reading);
        Assert.Equal("api api api", Sources(reading));

        JsonElement[] byNatives = HarvestWith(Throw, out TestGame game, out reading);

        Assert.Equal(whole.Select(Label), byNatives.Select(Label));
        Assert.Equal("natives natives natives", Sources(reading));
        Assert.Equal(3, game.Notifications.Count(message => message.Contains("natives are used instead", StringComparison.Ordinal)));
    }

    [Fact]
    public void Empty_lists_are_replaced_when_natives_find_entities()
    {
        JsonElement[] whole = HarvestWith(null, out _, out _);
        JsonElement[] byNatives = HarvestWith(_ => [], out _, out JsonElement reading);

        Assert.Equal(whole.Select(Label), byNatives.Select(Label));
        Assert.Equal("natives natives natives", Sources(reading));
    }

    [Fact]
    public void One_broken_list_does_not_affect_the_others()
    {
        HarvestWith(pool => pool == PoolKind.Props ? Throw(pool) : null, out TestGame game, out JsonElement reading);

        Assert.Equal("api api natives", Sources(reading));
        Assert.DoesNotContain(Hash.GET_PED_NEARBY_VEHICLES, game.Calls);
    }

    [Fact]
    public void Empty_world_is_not_a_broken_list()
    {
        using var driver = new ScriptDriver();
        driver.Game.PlayersVehicle = driver.Game.Add(Car("asea", 200));
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        driver.Tick(EnoughTicksForAFrame);

        Assert.Contains(Hash.GET_PED_NEARBY_PEDS, driver.Game.Calls);
        Assert.DoesNotContain(driver.Game.Notifications, message => message.Contains("natives are used", StringComparison.Ordinal));
    }

    [Fact]
    public void Build_unknown_to_the_api_is_read_through_natives()
    {
        using var driver = new ScriptDriver(prepare: game => game.Build = TestGame.Legacy(3258), faces: LightTests.TableOfOne);
        HarvestTests.Street(driver.Game);
        driver.Game.AfterListing = () => Assert.Fail("The API was asked to list what is near.");
        driver.Press(Keys.L);
        driver.Press(Keys.K);
        driver.Tick(EnoughTicksForAFrame);
        driver.WaitForDisk();

        Assert.Single(
            driver.Game.Notifications,
            message => message.Contains("newer than ScriptHookVDotNet 3.6.0 knows", StringComparison.Ordinal)
        );
        Assert.Contains("premier", Assert.Single(driver.Labels()), StringComparison.Ordinal);
    }

    [Fact]
    public void Known_prop_stays_listed_when_a_closer_one_appears()
    {
        using var driver = new ScriptDriver(faces: LightTests.TableOfOne);
        HarvestTests.Street(driver.Game);
        driver.Game.BrokenList = Throw;
        int first = driver.Game.Add(LightTests.LightAt(new Vector3D(103, 215, 0), Axes.Identity));
        driver.Press(Keys.L);
        driver.Game.Entities[first].Pose = new Pose(new Vector3D(130, 290, 0), Axes.Identity);
        driver.Game.Add(LightTests.LightAt(new Vector3D(97, 215, 0), Axes.Identity));
        driver.Tick(10);
        driver.Press(Keys.L);
        driver.Press(Keys.K);
        driver.Tick(EnoughTicksForAFrame);
        driver.WaitForDisk();

        Assert.Equal(
            2,
            Objects(driver)
                .Count(label =>
                    label.GetProperty("class").GetString() == "trafficLight" && label.GetProperty("space").ValueKind == JsonValueKind.Null
                )
        );
    }

    private static JsonElement[] HarvestWith(Func<PoolKind, int[]?>? broken, out TestGame game, out JsonElement reading)
    {
        using var driver = new ScriptDriver(faces: LightTests.TableOfOne);
        HarvestTests.Street(driver.Game);
        driver.Game.Add(LightTests.LightAt(new Vector3D(104, 230, 0), Axes.Identity));
        driver.Game.BrokenList = broken;
        driver.Press(Keys.K);
        driver.Tick(EnoughTicksForAFrame);
        driver.WaitForDisk();
        game = driver.Game;
        string session = File.ReadAllText(Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "session.json"));
        reading = JsonDocument.Parse(session).RootElement.GetProperty("reading");
        return Objects(driver);
    }

    private static JsonElement[] Objects(ScriptDriver driver) =>
        [.. JsonDocument.Parse(Assert.Single(driver.Labels())).RootElement.GetProperty("objects").EnumerateArray()];

    /// <summary>A label without its number, which follows the order of the list.</summary>
    private static string Label(JsonElement label) =>
        $"{label.GetProperty("class")} {label.GetProperty("model")} {label.GetProperty("box2d")}";

    private static string Sources(JsonElement reading) =>
        $"{reading.GetProperty("vehicles")} {reading.GetProperty("peds")} {reading.GetProperty("props")}";

    /// <summary>What a list does whose pool the API looks for in vain.</summary>
    internal static int[] Throw(PoolKind pool) =>
#pragma warning disable CA2201 // This is what the API throws.
        throw new NullReferenceException($"There is no pool of {pool}.");
#pragma warning restore CA2201

    private static GameEntity Car(string name, double north) =>
        new()
        {
            Pool = PoolKind.Vehicles,
            Name = name,
            Pose = new Pose(new Vector3D(100, north, 0.6), Axes.Identity),
        };
}
