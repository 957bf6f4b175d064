using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Text.Json;
using System.Windows.Forms;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests;

/// <summary>What a client and the player see of a drive over the bridge, from its first frame to its end.</summary>
public sealed class BridgeDriveTests : ServedGame
{
    // Half a second of the test game, and the frame in which it is over.
    private const int FramesOfPatience = 11;

    [Fact]
    public void Controls_of_a_client_reach_the_games_controls()
    {
        using ScriptDriver driver = Driven();
        using SocketClient client = Connect();
        Say(driver, client, """{"type":"controls","steering":0.25,"throttle":0.5,"brake":0.125}""", () => driver.Game.Controls[Steer] != 0);

        // The wheel's sign is the other way round in the game.
        Assert.Equal(-0.25f, driver.Game.Controls[Steer]);
        Assert.Equal(0.5f, driver.Game.Controls[Accelerate]);
        Assert.Equal(0.125f, driver.Game.Controls[Brake]);
        Assert.False(driver.Game.Controls.ContainsKey(Handbrake));
    }

    [Fact]
    public void Client_gets_frames_with_picture_and_state_without_the_HUD()
    {
        using ScriptDriver driver = Driven();
        using SocketClient client = Connect();
        Say(driver, client, """{"type":"requestFrame"}""", () => client.Stream.DataAvailable);
        (JsonElement header, byte[] png) = client.Receive();

        Assert.Equal("frame", header.GetProperty("type").GetString());
        Assert.Equal(8, header.GetProperty("speedMetresPerSecond").GetDouble());
        Assert.Equal([100, 200, 0.6], header.GetProperty("position").EnumerateArray().Select(part => Math.Round(part.GetDouble(), 4)));
        Assert.Equal((280, 210), (BigEndian(png, 16), BigEndian(png, 20)));
        Assert.Equal(0, driver.Screen.SpoiltPictures);
    }

    [Fact]
    public void Indicators_of_a_client_are_driven_by_the_controller()
    {
        using ScriptDriver driver = Driven();
        using SocketClient client = Connect();

        // The lane's middle is 0.5 m to the left of the car: DeepDriving steers left by (0 + 0.5 / 8) / 0.541052 / 1.5 = 0.0770, and
        // then by 2.5 · 0.0770 + 0.75 of it only where it is more than 0.1. That is of the lock of TORCS, 0.541052 rad; of the game's
        // 40 degrees it is 0.0770 · 0.541052 / 0.698132 = 0.0597. At 8 m/s it wants 20, so full throttle.
        Say(
            driver,
            client,
            """{"type":"indicators","values":[0,-7,3.5,7,75,75,-9.5,-2.5,1.5,9.5,75,75,75]}""",
            () => driver.Game.Controls[Steer] != 0
        );

        Assert.Equal(-0.0597f, driver.Game.Controls[Steer], 4);
        Assert.Equal(1f, driver.Game.Controls[Accelerate]);
    }

    [Fact]
    public void Silent_client_makes_the_car_brake()
    {
        using ScriptDriver driver = Driven();
        using SocketClient client = Connect();
        Say(driver, client, """{"type":"controls","steering":0.25,"throttle":0.5,"brake":0}""", () => driver.Game.Controls[Steer] != 0);
        driver.Tick(FramesOfPatience);

        Assert.Equal((0f, 0f, 1f), (driver.Game.Controls[Steer], driver.Game.Controls[Accelerate], driver.Game.Controls[Brake]));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-2)]
    public void Braking_a_car_that_stands_or_rolls_back_uses_the_handbrake(double speed)
    {
        using ScriptDriver driver = Driven();
        driver.Game.Entities[driver.Game.PlayersVehicle].Velocity = new Vector3D(0, speed, 0);
        driver.Tick(2);

        Assert.Equal((0f, 1f), (driver.Game.Controls[Brake], driver.Game.Controls[Handbrake]));
    }

    [Fact]
    public void Slight_braking_does_not_hold_a_car_told_to_start()
    {
        using ScriptDriver driver = Driven();
        using SocketClient client = Connect();
        driver.Game.Entities[driver.Game.PlayersVehicle].Velocity = default;
        Say(driver, client, """{"type":"controls","steering":0.25,"throttle":0.5,"brake":0.125}""", () => driver.Game.Controls[Steer] != 0);

        Assert.Equal((0.5f, 0f), (driver.Game.Controls[Accelerate], driver.Game.Controls[Brake]));
    }

    [Fact]
    public void Reset_places_a_standing_car_and_keeps_the_environment()
    {
        using ScriptDriver driver = Driven();
        using SocketClient client = Connect();
        GameEntity car = driver.Game.Entities[driver.Game.PlayersVehicle];
        Say(driver, client, """{"type":"reset","position":[-50,60,31],"headingDegrees":90}""", () => car.Velocity == default);
        Assert.Equal(new Vector3D(-50, 60, 31), car.Pose.Position);
        Assert.Equal(90, Angles.HeadingDegrees(car.Pose.Axes.Forward), 4);
        Assert.True(car.IsOnGround);

        Say(driver, client, """{"type":"environment","weather":"rain","timeOfDay":"17:30"}""", () => driver.Game.KeptWeather is not null);
        Assert.Equal(("rain", new TimeSpan(17, 30, 0)), (driver.Game.Environment.Weather, driver.Game.Environment.TimeOfDay));
        driver.Press(Keys.N);
        Assert.Null(driver.Game.KeptWeather);
    }

    [Theory]
    [InlineData("[-50,60,31]", "1e300")]
    [InlineData("[-50,60,31]", "-361")]
    [InlineData("[1e39,60,31]", "90")]
    public void Reset_to_impossible_values_is_refused_and_the_car_stays(string position, string headingDegrees)
    {
        using ScriptDriver driver = Driven();
        Pose before = driver.Game.Entities[driver.Game.PlayersVehicle].Pose;
        using SocketClient client = Connect();
        client.Send($"{{\"type\":\"reset\",\"position\":{position},\"headingDegrees\":{headingDegrees}}}");
        Until(driver, () => driver.Log().Contains("The bridge: ", StringComparison.Ordinal));
        driver.Tick(2);

        Assert.Equal(before, driver.Game.Entities[driver.Game.PlayersVehicle].Pose);
    }

    [Fact]
    public void Lock_step_advances_the_world_and_ends_with_the_drive()
    {
        using ScriptDriver driver = Driven();
        using SocketClient client = Connect();
        Say(driver, client, """{"type":"pause","paused":true}""", () => driver.Game.IsPaused);
        int stood = driver.Game.TimerMilliseconds;
        Say(driver, client, """{"type":"step","seconds":0.5}""", () => !driver.Game.IsPaused);
        driver.Tick(30);

        Assert.True(driver.Game.IsPaused);
        Assert.Equal(500, driver.Game.TimerMilliseconds - stood);
        driver.Script.RaiseKeyDown(Keys.W);
        Assert.False(driver.Game.IsPaused);
    }

    [Fact]
    public void Abort_from_another_thread_during_a_step_restores_everything()
    {
        using ScriptDriver driver = Driven();
        using (SocketClient client = Connect())
        {
            Say(driver, client, """{"type":"environment","weather":"foggy"}""", () => driver.Game.KeptWeather is not null);
            Say(driver, client, """{"type":"pause","paused":true}""", () => driver.Game.IsPaused);
        }

        var loader = new Thread(() =>
        {
            driver.Script.RaiseAborted();
            driver.Script.RaiseAborted();
        });
        loader.Start();
        loader.Join();

        Assert.False(driver.Game.IsPaused);
        Assert.Null(driver.Game.KeptWeather);
        Assert.Empty(driver.Game.Cameras);
        driver.Tick(2);
        Assert.Empty(driver.Game.Controls);

        // The port is free again.
        new TcpListener(IPAddress.Loopback, Port).Dispose();
        using ScriptDriver next = Driven();
    }

    [Fact]
    public void Key_ends_the_drive_and_starts_another_at_the_same_place()
    {
        using ScriptDriver driver = Driven();
        for (int again = 0; again < 3; again++)
        {
            driver.Press(Keys.N);
            driver.Tick();
            Assert.Contains("The car is yours.", driver.Game.Notifications[^1], StringComparison.Ordinal);
            Assert.Empty(driver.Game.Controls);
            Start(driver);
        }
    }

    [Fact]
    public void Harvest_and_drive_do_not_run_at_the_same_time()
    {
        using ScriptDriver driver = Driven();
        driver.Press(Keys.J);
        driver.Tick(2);
        Assert.Contains(driver.Game.Notifications, message => message.Contains("The drive has ended.", StringComparison.Ordinal));
        driver.Press(Keys.N);

        Assert.Contains("End the harvest first", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.Empty(driver.Game.Controls);
    }

    [Fact]
    public void Status_line_shows_the_client_state_outside_pictures_only()
    {
        using ScriptDriver driver = Driven("Rate = 1\n");
        using SocketClient client = Connect();
        var lines = new HashSet<string>();
        bool HasShown(string beginning)
        {
            lines.UnionWith(driver.Game.Texts);
            return lines.Any(line => line.StartsWith(beginning, StringComparison.Ordinal));
        }

        Until(driver, () => HasShown("BRAKING, no client drives at 127.0.0.1:"));
        Say(
            driver,
            client,
            """{"type":"controls","steering":0.5,"throttle":0,"brake":0}""",
            () => HasShown("DRIVEN by the client at 127.0.0.1:")
        );
        int grabs = driver.Screen.Grabs;
        Say(driver, client, """{"type":"requestFrame"}""", () => driver.Screen.Grabs >= grabs + 3);

        Assert.Equal(0, driver.Screen.SpoiltPictures);
    }

    [Fact]
    public void Status_line_shows_a_long_folder_whole()
    {
        string name = string.Concat(Enumerable.Repeat("Straße ", 20)) + "end";
        using var driver = new ScriptDriver($"[Bridge]\nKind = Folder\nFolder = {name}\nRate = 1\n");
        Street(driver.Game);
        Start(driver);

        Until(driver, () => driver.Game.Texts.Any(text => text.Contains($"{name}  ", StringComparison.Ordinal)));
    }

    [Fact]
    public void Shared_folder_of_figure_23_drives_as_well()
    {
        using var driver = new ScriptDriver("[Bridge]\nKind = Folder\nFolder = shared\n");
        Street(driver.Game);
        Start(driver);
        string folder = Path.Combine(driver.Folder, "shared");
        Until(driver, () => File.Exists(Path.Combine(folder, "state.txt")));
        Drop(folder, "controls.txt", "0.75 0 0\n");
        Until(driver, () => driver.Game.Controls[Steer] != 0);

        Assert.Equal(-0.75f, driver.Game.Controls[Steer]);
    }
}
