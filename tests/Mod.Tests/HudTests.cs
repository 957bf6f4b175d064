using System.Windows.Forms;
using GTA.Native;

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

    private static ScriptDriver Harvesting()
    {
        var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(3);
        return driver;
    }
}
