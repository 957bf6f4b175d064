using System.Windows.Forms;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

public sealed class TestCarTests
{
    private const int EnoughTicksToLoad = 10;

    [Fact]
    public void Key_spawns_the_car_of_the_thesis_beside_the_player()
    {
        using var driver = new ScriptDriver();
        driver.Press(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);

        GameEntity car = Assert.Single(driver.Game.Vehicles);
        Assert.Equal(TestGame.AdderHash, car.Model);
        Assert.True(car.IsInvincible);
        Assert.False(car.EngineCanDegrade || car.PetrolTankCanBeDamaged || car.TyresCanBurst || car.WheelsCanBreak || car.IsDamagedVisibly);
        Assert.Equal((0, 38), car.Colours);
        Assert.Equal("HARVEST", car.Plate);
        Assert.True(car.IsOnGround);

        // The player stands at (10, 20, 30) and looks west (heading 90), so 4 m to the right is 4 m north.
        Assert.Equal(new Vector3D(10, 24, 30), car.Pose.Position);
        Assert.Equal(90, Angles.HeadingDegrees(car.Pose.Axes.Forward), 4);
    }

    [Fact]
    public void Car_waits_for_its_model_without_stopping_the_game()
    {
        using var driver = new ScriptDriver();
        driver.Press(Keys.NumPad0);

        Assert.Empty(driver.Game.Vehicles);
        Assert.Contains(Hash.REQUEST_MODEL, driver.Game.Calls);
        driver.Tick(EnoughTicksToLoad);
        Assert.Single(driver.Game.Vehicles);
        Assert.Contains(Hash.SET_MODEL_AS_NO_LONGER_NEEDED, driver.Game.Calls);
    }

    [Fact]
    public void Second_key_press_removes_the_earlier_car()
    {
        using var driver = new ScriptDriver();
        driver.Press(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);
        GameEntity first = driver.Game.Vehicles.Single();
        driver.Press(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);

        Assert.NotSame(first, Assert.Single(driver.Game.Vehicles));

        // The clock of the test has not moved: the second message comes at once after the first, and is shown.
        Assert.Equal(2, driver.Game.Notifications.Count(message => message.Contains("The test car is here", StringComparison.Ordinal)));
    }

    [Fact]
    public void Held_key_spawns_one_car_on_release()
    {
        using var driver = new ScriptDriver();
        for (int repeat = 0; repeat < 50; repeat++)
        {
            driver.Script.RaiseKeyDown(Keys.NumPad0);
            driver.Tick();
        }

        Assert.Empty(driver.Game.Vehicles);
        driver.Script.RaiseKeyUp(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);
        Assert.Single(driver.Game.Vehicles);
        Assert.Equal(1, driver.Game.Calls.Count(native => native == Hash.CREATE_VEHICLE));
    }

    [Fact]
    public void Full_vehicle_pool_is_reported_and_a_retry_works()
    {
        using var driver = new ScriptDriver();
        driver.Game.VehiclePoolIsFull = true;
        driver.Press(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);
        Assert.Contains("no room for another vehicle", Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);

        driver.Game.VehiclePoolIsFull = false;
        driver.Press(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);
        Assert.Single(driver.Game.Vehicles);
    }

    [Fact]
    public void Unknown_model_is_reported_with_the_setting_to_change()
    {
        using var driver = new ScriptDriver("[TestCar]\nModel = notacar\n");
        driver.Press(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);

        Assert.Empty(driver.Game.Vehicles);
        Assert.Contains(
            "no vehicle 'notacar'. Change Model under [TestCar]",
            Assert.Single(driver.Game.Notifications),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Aborting_twice_from_another_thread_removes_the_car_once()
    {
        using var driver = new ScriptDriver();
        driver.Press(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);
        var otherThread = new Thread(driver.Script.RaiseAborted);
        otherThread.Start();
        otherThread.Join();
        driver.Script.RaiseAborted();

        Assert.Empty(driver.Game.Vehicles);
        Assert.Equal(1, driver.Game.Calls.Count(native => native == Hash.DELETE_VEHICLE));
    }

    [Fact]
    public void Car_deleted_by_a_saved_game_is_not_deleted_again()
    {
        using var driver = new ScriptDriver();
        driver.Press(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);
        driver.Game.Entities.Remove(driver.Game.Entities.Single(entity => entity.Value.Name == TestGame.Adder).Key);
        driver.Reload();
        driver.Tick();

        Assert.DoesNotContain(Hash.DELETE_VEHICLE, driver.Game.Calls);
        driver.Press(Keys.NumPad0);
        driver.Tick(EnoughTicksToLoad);
        Assert.Single(driver.Game.Vehicles);
    }
}
