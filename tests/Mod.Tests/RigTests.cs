using System.Globalization;
using System.Text.Json;
using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>Harvests with a rig beside the settings.</summary>
public sealed class RigTests
{
    private const string Ini = "[Harvest]\nRig = rig.json\nMotion = On\n";

    // Freezing, two views that each stand still for the four ticks that a picture may lag, and rays: fewer than 40 ticks.
    private const int TicksOfAMoment = 40;

    /// <summary>Two cameras and a LiDAR.</summary>
    public const string Rig = """
        {"name":"pair","cameras":[
        {"name":"ahead","position":[0,2,0.5],"verticalFovDegrees":50,"width":64,"height":48},
        {"name":"left","position":[-1,0,1],"yawDegrees":90,"pitchDegrees":-5,"verticalFovDegrees":70,"width":64,"height":48}],
        "lidars":[{"name":"top","position":[0,0,1.8],"beamsDegrees":[0,-10],"columns":36,"rangeMetres":40}]}
        """;

    public static TheoryData<Hash> Natives => [.. OwnNatives];

    /// <summary>The natives that only a harvest with a rig calls.</summary>
    internal static IReadOnlyList<Hash> OwnNatives { get; } = [Hash.SET_CAM_FOV];

    [Fact]
    public void Moment_has_the_views_and_points_of_the_rig()
    {
        using ScriptDriver driver = Start(Rig);
        int car = driver.Game.PlayersVehicle;
        driver.Press(Keys.J);
        driver.Tick(5 * TicksOfAMoment);
        driver.Press(Keys.J);
        driver.WaitForDisk();

        JsonElement[] labels = [.. driver.Labels().Select(line => JsonDocument.Parse(line).RootElement)];
        Assert.True(labels.Length >= 4, string.Join('\n', driver.Game.Notifications));
        Assert.Equal(0, labels.Length % 2);
        Assert.Equal(["ahead", "left", "ahead", "left"], labels.Take(4).Select(label => label.GetProperty("view").GetString()));

        // The car looks north. The left camera is a metre to its west and one above, and looks west, 5 degrees down.
        Vector3D place = driver.Game.Entities[car].Pose.Position;
        JsonElement left = labels[1].GetProperty("camera");
        Assert.Equal([place.X - 1, place.Y, place.Z + 1], Numbers(left, "position"), Near);
        Assert.Equal([-0.9962, 0, -0.0872], Numbers(left, "forward"), Near);
        Assert.Equal(70, left.GetProperty("verticalFovDegrees").GetDouble(), 3);

        JsonElement sweep = Assert.Single(labels[0].GetProperty("lidar").EnumerateArray());
        Assert.Equal(72, sweep.GetProperty("raysCast").GetInt32());
        string points = Path.Combine(Session(driver), sweep.GetProperty("file").GetString()!);
        Assert.Equal(24 * sweep.GetProperty("points").GetInt32(), new FileInfo(points).Length);
        Assert.NotEqual(0, sweep.GetProperty("points").GetInt32());
        Assert.NotEmpty(labels[2].GetProperty("motion").EnumerateArray());
        Assert.All(labels[2].GetProperty("motion").EnumerateArray(), row => Assert.Equal(13, row.GetArrayLength()));
    }

    [Fact]
    public void Camera_returns_to_its_usual_place_after_the_harvest()
    {
        using ScriptDriver driver = Start(Rig);
        driver.Press(Keys.J);
        driver.Tick(TicksOfAMoment);
        GameCamera camera = Assert.Single(driver.Game.Cameras).Value;
        driver.Press(Keys.J);
        driver.WaitForDisk();

        Assert.Equal((new Vector3D(0, 2, 0.4f), Axes.Identity, 50), (camera.Offset, camera.Turn, camera.VerticalFovDegrees));
        Assert.False(driver.Game.IsPaused);
    }

    [Fact]
    public void One_frame_is_one_moment_of_the_rig()
    {
        using ScriptDriver driver = Start(Rig);
        driver.Press(Keys.K);
        driver.UntilMessage("The harvest ended: 2 frames");
        driver.WaitForDisk();
        driver.Press(Keys.K);
        driver.Until(() => driver.Game.Notifications.Count(message => message.Contains("ended: 2 frames", StringComparison.Ordinal)) == 2);
        driver.WaitForDisk();

        Assert.Equal(4, driver.Labels().Length);
    }

    [Fact]
    public void Window_of_another_shape_is_told_once()
    {
        using ScriptDriver driver = Start(Rig.Replace("\"height\":48}],", "\"height\":36}],", StringComparison.Ordinal));
        driver.Press(Keys.J);
        driver.Tick(TicksOfAMoment);

        Assert.Equal(1, driver.Game.Notifications.Count(message => message.Contains("of 'left' are 64 x 36", StringComparison.Ordinal)));
    }

    [Theory]
    [InlineData("", "", "there is no file other.json")]
    [InlineData("\"width\":64", "\"width\":4", "cameras[0].width must be a number from 32 to 8192.")]
    public void Rig_that_cannot_be_used_is_told_and_refuses_a_harvest(string good, string bad, string message)
    {
        string ini = good.Length == 0 ? Ini.Replace("rig.json", "other.json", StringComparison.Ordinal) : Ini;
        using ScriptDriver driver = Start(good.Length == 0 ? Rig : Rig.Replace(good, bad, StringComparison.Ordinal), ini);
        driver.Tick();
        driver.Press(Keys.J);

        Assert.Equal(2, driver.Game.Notifications.Count(told => told.Contains(message, StringComparison.Ordinal)));
        Assert.False(Directory.Exists(driver.Output));
    }

    [Theory]
    [InlineData("Mode = Live\n", "Rig needs Mode = Freeze")]
    [InlineData("Masks = Coded\n", "Rig needs Masks = Rays or Off.")]
    [InlineData("PairHours = 6\n", "Rig cannot be used together with PairWeathers, PairHours and PairWithout.")]
    public void Rig_refuses_settings_that_contradict_it(string setting, string message)
    {
        using ScriptDriver driver = Start(Rig, Ini + setting);
        driver.Press(Keys.J);

        Assert.Contains(driver.Game.Notifications, told => told.Contains(message, StringComparison.Ordinal));
        Assert.False(Directory.Exists(driver.Output));
    }

    [Fact]
    public void Camera_wider_than_those_of_the_game_is_refused()
    {
        using ScriptDriver driver = Start(Rig.Replace("\"verticalFovDegrees\":70", "\"verticalFovDegrees\":131", StringComparison.Ordinal));
        driver.Press(Keys.J);

        Assert.Contains(
            driver.Game.Notifications,
            told => told.Contains("'left' of the rig needs a verticalFovDegrees of at most 130", StringComparison.Ordinal)
        );
        Assert.False(Directory.Exists(driver.Output));
    }

    [Theory]
    [InlineData("[-1,0,1]", "'left'")]
    [InlineData("[0,0,1.8]", "'top'")]
    public void Sensor_inside_the_vehicle_refuses_a_harvest(string place, string name)
    {
        // The body of the car is 2 m wide, 4 m long and 2 m high around its origin.
        using ScriptDriver driver = Start(Rig.Replace(place, "[0.5,-1,0.3]", StringComparison.Ordinal));
        driver.Press(Keys.J);

        Assert.Contains(
            driver.Game.Notifications,
            told => told.Contains($"{name} of the rig 'pair' is inside the body of the vehicle. Move it outside.", StringComparison.Ordinal)
        );
        Assert.False(Directory.Exists(driver.Output));
    }

    [Fact]
    public void Rig_beyond_the_budget_refuses_a_harvest_with_its_time()
    {
        // Two turns of 2,000,000 rays take 4,000 ticks, and each view at least two: 67 s at 60 ticks a second.
        string beams = string.Join(',', Enumerable.Range(0, 100).Select(beam => (beam / 4m).ToString(CultureInfo.InvariantCulture)));
        string lidar = "{\"name\":\"top\",\"position\":[0,0,1.8],\"beamsDegrees\":[" + beams + "],\"columns\":20000}";
        string cameras = Rig[..Rig.IndexOf("{\"name\":\"top\"", StringComparison.Ordinal)];
        string rig = cameras + lidar + "," + lidar.Replace("top", "low", StringComparison.Ordinal) + "]}";
        using ScriptDriver driver = Start(rig);
        driver.Press(Keys.J);

        Assert.Contains(
            driver.Game.Notifications,
            told => told.Contains("A moment of the rig 'pair' takes about 67 s; at most 60 s are allowed.", StringComparison.Ordinal)
        );
        Assert.False(Directory.Exists(driver.Output));
    }

    [Theory]
    [MemberData(nameof(Natives))]
    public void Fault_of_the_camera_ends_the_harvest_and_gives_it_back(Hash broken)
    {
        using ScriptDriver driver = Harvesting();
        driver.Game.Fault = native => native == broken ? new InvalidOperationException("The native is broken.") : null;
        driver.UntilMessage("The native is broken.");
        driver.Game.Fault = _ => null;
        driver.Press(Keys.O);
        driver.WaitForDisk();

        Assert.False(driver.Game.IsPaused);
        Assert.Equal(-1, driver.Game.RenderingCamera);
        Assert.Empty(driver.Game.Cameras);
    }

    /// <summary>A game whose harvest with a rig has begun.</summary>
    internal static ScriptDriver Harvesting()
    {
        ScriptDriver driver = Start(Rig);
        driver.Press(Keys.J);
        return driver;
    }

    private static ScriptDriver Start(string rig, string ini = Ini)
    {
        var driver = new ScriptDriver(
            ini,
            game => File.WriteAllText(Path.Combine(Path.GetDirectoryName(game.ScriptFile)!, "rig.json"), rig)
        );
        driver.Game.PlayersVehicle = driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Vehicles,
                Name = "adder",
                Pose = new Pose(new Vector3D(100, 200, 0.6), Axes.Identity),
            }
        );
        driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Vehicles,
                Name = "asea",
                Pose = new Pose(new Vector3D(100, 214, 0.6), Axes.Identity),
            }
        );
        return driver;
    }

    private static string Session(ScriptDriver driver) => Assert.Single(Directory.GetDirectories(driver.Output));

    private static double[] Numbers(JsonElement of, string name) =>
        [.. of.GetProperty(name).EnumerateArray().Select(number => number.GetDouble())];

    private static bool Near(double expected, double actual) => Math.Abs(expected - actual) < 1e-3;
}
