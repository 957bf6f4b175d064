using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

public sealed class CameraMountTests
{
    [Fact]
    public void Key_on_foot_asks_the_player_to_enter_a_vehicle()
    {
        using var driver = new ScriptDriver();
        driver.Press(Keys.I);

        Assert.Empty(driver.Game.Cameras);
        Assert.Contains("Enter a vehicle first", Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);
    }

    [Fact]
    public void Key_in_a_vehicle_mounts_the_camera_of_the_thesis()
    {
        using var driver = new ScriptDriver();
        SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);

        // The car's origin is (100, 200, 5): 2 m ahead is 2 m north, and 0.4 m up.
        (Pose pose, double fov, _, _) = driver.Game.RenderedCamera;
        Assert.Equal(50, fov);
        AssertNear(new Vector3D(100, 202, 5.4), pose.Position);
    }

    [Fact]
    public void Camera_turns_rigidly_with_the_car()
    {
        using var driver = new ScriptDriver();
        GameEntity car = SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);
        var turned = Axes.FromEuler(new EulerAngles(10, 20, 30));
        car.Pose = new Pose(new Vector3D(-7, 8, 9), turned);
        driver.Tick();

        Pose pose = driver.Game.RenderedCamera.Pose;
        AssertNear(turned.Forward, pose.Axes.Forward);
        AssertNear(turned.Up, pose.Axes.Up);
        AssertNear(new Vector3D(-7, 8, 9) + (turned.Forward * 2) + (turned.Up * 0.4), pose.Position);
    }

    [Fact]
    public void Settings_change_offset_and_field_of_view()
    {
        using var driver = new ScriptDriver("[Camera]\nVerticalFov = 72.5\nOffsetRight = -0.3\nOffsetForward = 0.25\nOffsetUp = 1\n");
        SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);

        (Pose pose, double fov, _, _) = driver.Game.RenderedCamera;
        Assert.Equal(72.5f, fov);
        AssertNear(new Vector3D(99.7, 200.25, 6), pose.Position);
    }

    [Fact]
    public void Restore_key_gives_the_view_back_and_leaves_no_camera()
    {
        using var driver = new ScriptDriver();
        SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);
        driver.Press(Keys.O);

        Assert.Equal(-1, driver.Game.RenderingCamera);
        Assert.Empty(driver.Game.Cameras);
        Assert.Equal(1, driver.Game.Calls.Count(native => native == Hash.DESTROY_CAM));
        driver.Press(Keys.O);
        Assert.Equal(1, driver.Game.Calls.Count(native => native == Hash.DESTROY_CAM));
    }

    [Fact]
    public void Camera_of_another_mod_is_left_alone()
    {
        using var driver = new ScriptDriver();
        GameEntity car = SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);
        const int others = 9_000;
        driver.Game.Cameras[others] = new GameCamera
        {
            VerticalFovDegrees = 40,
            Pose = default,
            IsActive = true,
            AttachedTo = driver.Game.HandleOf(car),
        };
        driver.Game.RenderingCamera = others;
        driver.Press(Keys.O);

        Assert.Equal(others, driver.Game.RenderingCamera);
        Assert.Equal([others], driver.Game.Cameras.Keys);
    }

    [Fact]
    public void Mounting_twice_leaves_one_camera()
    {
        using var driver = new ScriptDriver();
        SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);
        driver.Press(Keys.I);

        Assert.Single(driver.Game.Cameras);
        Assert.Equal(driver.Game.Cameras.Keys.Single(), driver.Game.RenderingCamera);
    }

    [Fact]
    public void Vehicle_that_vanishes_gives_the_view_back_with_a_message()
    {
        using var driver = new ScriptDriver();
        GameEntity car = SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);
        driver.Game.Entities.Remove(driver.Game.HandleOf(car));
        driver.Tick();

        Assert.Equal(-1, driver.Game.RenderingCamera);
        Assert.Empty(driver.Game.Cameras);
        Assert.Contains("vehicle with the camera is gone", driver.Game.Notifications[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Leaving_the_vehicle_restores_the_view()
    {
        using var driver = new ScriptDriver();
        SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);
        driver.Tick(3);
        Assert.Single(driver.Game.Cameras);
        driver.Game.PlayersVehicle = 0;
        driver.Tick();

        Assert.Equal(-1, driver.Game.RenderingCamera);
        Assert.Empty(driver.Game.Cameras);
        Assert.Contains("You left the vehicle", driver.Game.Notifications[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Camera_that_cannot_be_shown_is_not_mounted_for_a_harvest()
    {
        using var driver = new ScriptDriver();
        SitInCar(driver.Game, Axes.Identity);
        driver.Game.Fault = native => native == Hash.SET_CAM_ACTIVE ? new InvalidOperationException("No view.") : null;
        driver.Press(Keys.J);
        driver.Press(Keys.J);
        driver.Tick(20);

        Assert.Equal(0, driver.Screen.Grabs);
        Assert.False(Directory.Exists(driver.Output));
        driver.Game.Fault = _ => null;
    }

    [Fact]
    public void Changing_the_vehicle_restores_the_view()
    {
        using var driver = new ScriptDriver();
        SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);
        SitInCar(driver.Game, Axes.Identity);
        driver.Tick();

        Assert.Empty(driver.Game.Cameras);
    }

    [Fact]
    public void Build_without_rigid_cameras_gets_a_message()
    {
        using var driver = new ScriptDriver(prepare: game => game.Build = TestGame.Legacy(2060));
        SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);

        Assert.Contains("older than 1.0.2189", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.DoesNotContain(Hash.HARD_ATTACH_CAM_TO_ENTITY, driver.Game.Calls);
    }

    [Fact]
    public void Aborted_gives_the_view_back()
    {
        using var driver = new ScriptDriver();
        SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.I);
        driver.Script.RaiseAborted();
        driver.Script.RaiseAborted();

        Assert.Equal(-1, driver.Game.RenderingCamera);
        Assert.Empty(driver.Game.Cameras);
    }

    internal static GameEntity SitInCar(TestGame game, Axes axes)
    {
        var car = new GameEntity
        {
            Pool = PoolKind.Vehicles,
            Name = "asea",
            Pose = new Pose(new Vector3D(100, 200, 5), axes),
        };
        game.PlayersVehicle = game.Add(car);
        return car;
    }

    private static void AssertNear(Vector3D expected, Vector3D actual)
    {
        // The offset goes through the game in single precision: half a unit in the last place of 0.4 is 1.5e-8 m.
        const double singlePrecision = 1e-6;
        Assert.InRange((expected - actual).Length, 0, singlePrecision);
    }
}
