using System.Windows.Forms;
using GTA.Native;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>What the game refuses to take back is returned to it repeatedly, until it accepts.</summary>
public sealed class GivingBackTests
{
    [Theory]
    [InlineData(Hash.GET_RENDERING_CAM)]
    [InlineData(Hash.RENDER_SCRIPT_CAMS)]
    [InlineData(Hash.SET_CAM_ACTIVE)]
    [InlineData(Hash.DESTROY_CAM)]
    public void Camera_is_removed_as_soon_as_the_game_allows(Hash broken)
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.I);
        Break(driver.Game, broken);
        driver.Press(Keys.O);
        Assert.NotEmpty(driver.Game.Cameras);
        driver.Game.Fault = _ => null;
        driver.Tick();

        Assert.Empty(driver.Game.LeftBehind);
    }

    [Theory]
    [InlineData(Hash.DOES_ENTITY_EXIST)]
    [InlineData(Hash.DELETE_VEHICLE)]
    [InlineData(Hash.SET_ENTITY_INVINCIBLE)]
    [InlineData(Hash.SET_MODEL_AS_NO_LONGER_NEEDED)]
    public void No_test_car_is_left_when_the_script_ends(Hash broken)
    {
        using var driver = new ScriptDriver();
        const int enoughTicksToLoad = 8;
        driver.Press(Keys.NumPad0);
        driver.Tick(enoughTicksToLoad);
        Break(driver.Game, broken);
        driver.Press(Keys.NumPad0);
        driver.Tick(enoughTicksToLoad);
        Assert.Contains(driver.Game.Notifications, message => message.Contains("The native is broken.", StringComparison.Ordinal));
        driver.Game.Fault = _ => null;
        driver.Press(Keys.NumPad0);
        driver.Tick(enoughTicksToLoad);
        Assert.Single(driver.Game.Vehicles);
        driver.Script.RaiseAborted();

        Assert.Empty(driver.Game.LeftBehind);
    }

    [Fact]
    public void Model_of_the_test_car_is_released_as_soon_as_possible()
    {
        using var driver = new ScriptDriver();
        const int enoughTicksToLoad = 8;
        Break(driver.Game, Hash.SET_MODEL_AS_NO_LONGER_NEEDED);
        driver.Press(Keys.NumPad0);
        driver.Tick(enoughTicksToLoad);
        Assert.Single(driver.Game.Vehicles);
        Assert.Equal(1, driver.Game.RequestedModels);
        driver.Game.Fault = _ => null;
        driver.Tick();

        Assert.Equal(0, driver.Game.RequestedModels);
    }

    [Theory]
    [InlineData("Paused", Hash.SET_GAME_PAUSED)]
    [InlineData("TimeScale", Hash.SET_TIME_SCALE)]
    public void World_resumes_as_soon_as_the_game_allows(string way, Hash broken)
    {
        using var driver = new ScriptDriver($"[Harvest]\nFreeze = {way}\n");
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Until(() => driver.Game.IsFrozen);
        Break(driver.Game, broken);
        driver.Press(Keys.O);
        driver.Tick();
        Assert.True(driver.Game.IsFrozen);
        driver.Game.Fault = _ => null;
        driver.Tick();

        Assert.Empty(driver.Game.LeftBehind);
    }

    private static void Break(TestGame game, Hash native) =>
        game.Fault = called => called == native ? new InvalidOperationException("The native is broken.") : null;
}
