using System.Text.Json;
using System.Windows.Forms;
using GTA.Hosting;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>Depth maps of the mod, by the game's rays.</summary>
public sealed class DepthTests
{
    [Fact]
    public void Frame_has_a_depth_map_of_rays()
    {
        using ScriptDriver driver = Start("Depth = On");
        driver.Press(Keys.K);
        driver.UntilMessage("The harvest ended: 1 frame");
        driver.WaitForDisk();

        JsonElement label = JsonDocument.Parse(Assert.Single(driver.Labels())).RootElement;
        Assert.NotEqual(0, label.GetProperty("rays").GetProperty("depth").GetInt32());
        string file = label.GetProperty("depth").GetProperty("sparse").GetString()!;
        Assert.Equal(
            1,
            Directory
                .EnumerateFiles(driver.Output, Path.GetFileName(file), SearchOption.AllDirectories)
                .Count(path => path.Replace('\\', '/').EndsWith("/" + file, StringComparison.Ordinal))
        );
    }

    [Fact]
    public void Depth_of_a_live_harvest_is_refused()
    {
        using ScriptDriver driver = Start("Depth = On\nMode = Live");
        driver.Press(Keys.J);

        Assert.Contains(driver.Game.Notifications, told => told.Contains("Depth needs Mode = Freeze", StringComparison.Ordinal));
        Assert.False(Directory.Exists(driver.Output));
    }

    private static ScriptDriver Start(string setting)
    {
        var driver = new ScriptDriver($"[Harvest]\nWidth = 64\nHeight = 48\n{setting}\n");
        driver.Game.PlayersVehicle = driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Vehicles,
                Name = "adder",
                Pose = new Pose(new Vector3D(100, 200, 0.6), Axes.Identity),
            }
        );
        return driver;
    }
}
