using System.Text.Json;
using System.Windows.Forms;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests;

/// <summary>Further pictures of a frozen moment, for which the mod sets the weather and the clock of the game.</summary>
public sealed class PairTests
{
    private const string Ini =
        "[Harvest]\nPairWeathers = rain, xmas\nPairHours = 6\nPairWithout = nearest-vehicle\nFreeze = Paused\nPairTicks = 60\n";

    /// <summary>More than the pictures of a moment take.</summary>
    private const int TicksOfAFrame = 400;

    private static readonly EnvironmentState Before = new("clouds", new TimeSpan(14, 5, 9));

    [Fact]
    public void Moment_is_photographed_under_every_sky()
    {
        using ScriptDriver driver = Harvesting();
        var skies = new HashSet<EnvironmentState>();
        for (int tick = 0; tick < TicksOfAFrame; tick++)
        {
            driver.WaitForDisk();
            driver.Tick();
            skies.Add(driver.Game.Environment);
        }

        driver.Press(Keys.J);
        driver.WaitForDisk();

        Assert.Equal(
            [Before, new EnvironmentState("rain", TimeSpan.FromHours(6)), new EnvironmentState("xmas", TimeSpan.FromHours(6))],
            skies.OrderBy(sky => sky.Weather, StringComparer.Ordinal)
        );
        Assert.Equal((Before, null), (driver.Game.Environment, driver.Game.KeptWeather));
        string session = Assert.Single(Directory.GetDirectories(driver.Output));
        JsonElement label = JsonDocument.Parse(File.ReadLines(Path.Combine(session, "labels.jsonl")).First()).RootElement;
        string[] files = [.. label.GetProperty("pairs").EnumerateArray().Select(pair => pair.GetProperty("file").GetString()!)];
        Assert.Equal(
            [
                "pairs/00000000/base-without-nearest-vehicle.png",
                "pairs/00000000/rain-06.png",
                "pairs/00000000/rain-06-without-nearest-vehicle.png",
                "pairs/00000000/xmas-06.png",
                "pairs/00000000/xmas-06-without-nearest-vehicle.png",
            ],
            files
        );
        Assert.All(files, file => Assert.True(File.Exists(Path.Combine(session, file))));
    }

    [Fact]
    public void Pictures_that_keep_changing_are_left_out_with_a_warning()
    {
        using ScriptDriver driver = Harvesting();
        driver.Screen.ShowsSky = false;
        for (int tick = 0; tick < TicksOfAFrame; tick++)
        {
            driver.WaitForDisk();
            driver.Tick();
        }

        driver.Press(Keys.J);
        driver.WaitForDisk();

        Assert.Contains("\"dropped\":\"unsettled\"", driver.Labels()[0], StringComparison.Ordinal);
        Assert.Contains(
            driver.Game.Notifications,
            message => message.Contains("further pictures of moments are missing", StringComparison.Ordinal)
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Sky_and_objects_are_given_back_after_an_abort_at_any_tick()
    {
        int changed = 0;
        for (int ticks = 0; ticks < TicksOfAFrame / 2; ticks += 10)
        {
            using ScriptDriver driver = Harvesting();
            for (int tick = 0; tick < ticks; tick++)
            {
                driver.WaitForDisk();
                driver.Tick();
            }

            changed += driver.Game.Environment == Before ? 0 : 1;
            driver.Script.RaiseAborted();
            driver.WaitForDisk();

            Assert.Equal((Before, null), (driver.Game.Environment, driver.Game.KeptWeather));
            Assert.DoesNotContain(driver.Game.Entities.Values, entity => entity.IsHidden);
        }

        Assert.True(changed > 3, "The harvest changed no sky, so that the test shows nothing.");
    }

    [Fact]
    public void Live_mode_refuses_pairs()
    {
        using var driver = new ScriptDriver(Ini + "Mode = Live\n");
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);

        Assert.Contains(
            driver.Game.Notifications,
            told => told.Contains("PairWeathers, PairHours and PairWithout need Mode = Freeze", StringComparison.Ordinal)
        );
        Assert.False(Directory.Exists(driver.Output));
    }

    private static ScriptDriver Harvesting()
    {
        var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        driver.Game.Environment = Before;
        driver.Screen.ShowsSky = true;
        driver.Press(Keys.J);
        return driver;
    }
}
