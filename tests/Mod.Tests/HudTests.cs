using System.Text.Json;
using System.Windows.Forms;
using GTA.Native;
using Harvester.Datasets.Diagnosis;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>Radar and head-up display are off for as long as pictures are taken, and on afterwards, however it ends.</summary>
public sealed class HudTests
{
    [Fact]
    public void Radar_and_hud_are_off_during_a_harvest_only()
    {
        using ScriptDriver driver = Harvesting();
        Assert.False(driver.Game.IsRadarOn);
        Assert.False(driver.Game.IsHudOn);

        driver.Press(Keys.J);
        driver.Tick(2);
        Assert.True(driver.Game.IsRadarOn);
        Assert.True(driver.Game.IsHudOn);
    }

    [Fact]
    public void Radar_and_hud_are_on_again_after_the_script_ends()
    {
        using ScriptDriver driver = Harvesting();
        driver.Script.RaiseAborted();

        Assert.True(driver.Game.IsRadarOn);
        Assert.True(driver.Game.IsHudOn);
    }

    [Fact]
    public void Radar_and_hud_are_on_again_after_a_failed_harvest()
    {
        using ScriptDriver driver = Harvesting();
        driver.Game.Fault = native => native == Hash.GET_ENTITY_MATRIX ? new InvalidOperationException("The native is broken.") : null;
        driver.Tick(4);
        driver.Game.Fault = _ => null;
        driver.Tick(2);

        Assert.True(driver.Game.IsRadarOn);
        Assert.True(driver.Game.IsHudOn);
    }

    [Fact]
    public void Refused_switching_is_tried_again()
    {
        using ScriptDriver driver = Harvesting();
        driver.Game.Fault = native => native == Hash.DISPLAY_HUD ? new InvalidOperationException("The native is broken.") : null;
        driver.Press(Keys.J);
        driver.Tick(3);
        driver.Game.Fault = _ => null;
        driver.Tick();

        Assert.True(driver.Game.IsHudOn);
    }

    [Fact]
    public void Display_that_is_off_stays_off()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        (driver.Game.IsRadarOn, driver.Game.IsHudOn) = (false, false);
        driver.Press(Keys.J);
        driver.Tick(3);
        driver.Press(Keys.J);
        driver.Tick(3);

        Assert.False(driver.Game.IsRadarOn);
        Assert.False(driver.Game.IsHudOn);
    }

    [Fact]
    public void Display_that_can_be_hidden_is_recorded_with_its_region() => AssertDisplay(_ => { }, "hidden", "lower left");

    [Fact]
    public void Radar_is_out_of_pictures_if_only_switching_it_off_works() =>
        AssertDisplay(game => game.HidesHudWhilePaused = false, "hidden", "lower left");

    [Fact]
    public void Radar_that_stays_while_the_game_is_paused_is_found()
    {
        AssertDisplay(
            game =>
            {
                game.HidesHudWhilePaused = false;
                game.SwitchesHudWhilePaused = false;
            },
            "stays",
            null,
            driver =>
                Assert.Contains(
                    driver.Game.Notifications,
                    message => message.Contains("Switch them off in the game's settings", StringComparison.Ordinal)
                )
        );
    }

    [Theory]
    [InlineData(1, "kept", null)]
    [InlineData(1.6, "clipped", "a grey of 192 comes back as 255")]
    public void Overexposed_pictures_are_found_before_the_first_frame(double gain, string state, string? warning)
    {
        using var driver = new ScriptDriver("[Harvest]\nCheckDisplay = On\n");
        driver.Screen.Gain = gain;
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        bool isSaidAtOnce = false;
        for (int tick = 0; tick < 160; tick++)
        {
            driver.Tick();
            isSaidAtOnce |= driver.Game.Texts.Any(text => text.Contains("are clipped", StringComparison.Ordinal));
        }

        driver.Press(Keys.J);
        driver.WaitForDisk();
        driver.Tick(2);

        string session = Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "session.json");
        JsonElement colours = JsonDocument.Parse(File.ReadAllText(session)).RootElement.GetProperty("start").GetProperty("colours");
        Assert.Equal(state, colours.GetProperty("state").GetString());
        Assert.Equal(warning is not null, isSaidAtOnce);
        Assert.Equal(
            warning is not null,
            driver.Game.Notifications.Any(message => message.Contains(warning ?? "are clipped", StringComparison.Ordinal))
        );
        Assert.Equal(
            warning is not null,
            Doctor
                .Examine(Path.GetDirectoryName(session)!, false)
                .Findings.Any(finding => finding.Cause.Contains("Auto HDR", StringComparison.Ordinal))
        );
    }

    private static void AssertDisplay(Action<TestGame> prepare, string state, string? region, Action<ScriptDriver>? further = null)
    {
        using var driver = new ScriptDriver("[Harvest]\nCheckDisplay = On\n", prepare);
        driver.Screen.ShowsRadar = true;
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(60);
        driver.Press(Keys.J);
        driver.WaitForDisk();
        driver.Tick(2);

        Assert.NotEmpty(driver.Labels());
        string session = Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "session.json");
        JsonElement display = JsonDocument.Parse(File.ReadAllText(session)).RootElement.GetProperty("start").GetProperty("display");
        Assert.Equal(state, display.GetProperty("state").GetString());
        Assert.Equal(region, display.GetProperty("region").GetString()?.Split(',')[0]);
        Assert.True(driver.Game.IsRadarOn);
        Assert.Equal(state == "stays", DoctorFinds(Path.GetDirectoryName(session)!));
        further?.Invoke(driver);
    }

    private static bool DoctorFinds(string session) =>
        Doctor.Examine(session, false).Findings.Any(finding => finding.Cause.Contains("radar and HUD", StringComparison.Ordinal));

    private static ScriptDriver Harvesting()
    {
        var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(3);
        return driver;
    }
}
