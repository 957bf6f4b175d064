using System.Text.Json;
using System.Windows.Forms;
using GTA.Hosting;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>Entities whose matrix another mod has scaled, sheared or mirrored.</summary>
public sealed class DistortedEntityTests
{
    private const int EnoughTicksForAFrame = 20;

    [Fact]
    public void Scaled_entity_is_labelled_at_its_scaled_size()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        Put(driver.Game, new Vector3D(2, 0, 0), new Vector3D(0, 1.5, 0), new Vector3D(0, 0, 4));
        JsonElement[] labels = Harvest(driver);

        // The model is 2 m wide, 4 m long and 1.5 m high.
        JsonElement scaled = labels.Single(label => label.GetProperty("model").GetString() == "blista");
        Assert.Equal(
            [4, 6, 6],
            scaled.GetProperty("box3d").GetProperty("halfExtents").EnumerateArray().Select(half => 2 * half.GetDouble())
        );
        Assert.Equal(0, Session(driver).GetProperty("reading").GetProperty("distortedEntities").GetInt32());
    }

    [Fact]
    public void Sheared_and_mirrored_entities_are_omitted_and_counted_once()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        Put(driver.Game, new Vector3D(1, 0, 0), new Vector3D(0.5, 1, 0), new Vector3D(0, 0, 1));
        Put(driver.Game, new Vector3D(-1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1));
        driver.Press(Keys.L);
        JsonElement[] labels = Harvest(driver);

        Assert.DoesNotContain(labels, label => label.GetProperty("model").GetString() == "blista");
        Assert.Contains(labels, label => label.GetProperty("model").GetString() == "premier");
        Assert.Equal(2, Session(driver).GetProperty("reading").GetProperty("distortedEntities").GetInt32());
        Assert.DoesNotContain(driver.Game.Notifications, message => message.Contains("failed", StringComparison.Ordinal));
    }

    [Fact]
    public void Sheared_camera_vehicle_ends_the_harvest_with_a_reason()
    {
        using var driver = new ScriptDriver();
        driver.Game.PlayersVehicle = Put(driver.Game, new Vector3D(1, 0, 0), new Vector3D(0.5, 1, 0), new Vector3D(0, 0, 1));
        driver.Press(Keys.J);
        driver.Tick(EnoughTicksForAFrame);

        Assert.Contains(driver.Game.Notifications, message => message.Contains("sheared or mirrored", StringComparison.Ordinal));
    }

    private static int Put(TestGame game, Vector3D right, Vector3D forward, Vector3D up) =>
        game.Add(
            new GameEntity
            {
                Pool = PoolKind.Vehicles,
                Name = "blista",
                Pose = new Pose(new Vector3D(97, 225, 0.6), Axes.Identity),
                Matrix = (right, forward, up),
            }
        );

    private static JsonElement[] Harvest(ScriptDriver driver)
    {
        driver.Press(Keys.K);
        driver.Tick(EnoughTicksForAFrame);
        driver.WaitForDisk();
        return [.. JsonDocument.Parse(Assert.Single(driver.Labels())).RootElement.GetProperty("objects").EnumerateArray()];
    }

    private static JsonElement Session(ScriptDriver driver) =>
        JsonDocument
            .Parse(File.ReadAllText(Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "session.json")))
            .RootElement;
}
