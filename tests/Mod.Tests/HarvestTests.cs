using System.Globalization;
using System.Text.Json;
using System.Text.RegularExpressions;
using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests;

public sealed class HarvestTests
{
    // A frozen frame needs one tick to freeze and four still ones; with waiting in between, ten ticks hold one.
    private const int TicksOfAFrame = 10;

    [Fact]
    public void Key_on_foot_asks_for_a_vehicle_and_harvests_nothing()
    {
        using var driver = new ScriptDriver();
        driver.Press(Keys.J);

        Assert.Contains("Enter a vehicle first", Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);
        Assert.False(Directory.Exists(driver.Output));
    }

    [Fact]
    public void Key_in_a_vehicle_mounts_the_camera_and_toggles_the_harvest()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(5 * TicksOfAFrame);
        driver.Press(Keys.J);
        driver.WaitForDisk();

        Assert.Single(driver.Game.Cameras);
        Assert.False(driver.Game.IsPaused);
        string session = Assert.Single(Directory.GetDirectories(driver.Output));
        string[] labels = File.ReadAllLines(Path.Combine(session, "labels.jsonl"));
        Assert.InRange(labels.Length, 4, 50);
        Assert.Equal(labels.Length, Directory.GetFiles(Path.Combine(session, "frames"), "*.png").Length);
        Assert.Contains($"The harvest ended: {labels.Length} frames", driver.Game.Notifications[^1], StringComparison.Ordinal);

        JsonElement objects = JsonDocument.Parse(labels[0]).RootElement.GetProperty("objects");
        Assert.Equal(["car", "pedestrian"], objects.EnumerateArray().Select(label => label.GetProperty("class").GetString()).Order());
    }

    [Fact]
    public void Label_of_a_two_wheeler_states_whether_it_has_a_rider()
    {
        const int cycles = 13,
            motorcycles = 8;
        using var driver = new ScriptDriver();
        Street(driver.Game);
        int ridden = driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Vehicles,
                Name = "scorcher",
                VehicleClass = cycles,
                Pose = new Pose(new Vector3D(97, 214, 0.6), Axes.Identity),
            }
        );
        driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Vehicles,
                Name = "bati",
                VehicleClass = motorcycles,
                Pose = new Pose(new Vector3D(103, 214, 0.6), Axes.Identity),
            }
        );
        driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Peds,
                Name = "a_m_y_cyclist_01",
                Pose = new Pose(new Vector3D(97, 214, 0.6), Axes.Identity),
                Vehicle = ridden,
            }
        );
        driver.Press(Keys.J);
        driver.Tick(5 * TicksOfAFrame);
        driver.Press(Keys.J);
        driver.WaitForDisk();

        string line = File.ReadLines(Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "labels.jsonl")).First();
        Assert.Equal(
            [("bicycle", "True"), ("car", ""), ("motorcycle", "False"), ("pedestrian", "")],
            JsonDocument
                .Parse(line)
                .RootElement.GetProperty("objects")
                .EnumerateArray()
                .Select(label => (label.GetProperty("class").GetString()!, label.GetProperty("hasRider").ToString()))
                .Order()
        );
    }

    [Fact]
    public void Pictures_show_neither_the_HUD_nor_the_overlay()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Press(Keys.L);
        driver.Press(Keys.J);
        bool wasDrawn = false;
        for (int tick = 0; tick < 5 * TicksOfAFrame; tick++)
        {
            driver.Tick();
            wasDrawn |= driver.Game.Texts.Count > 0 && driver.Game.Rectangles.Count > 0;
        }

        Assert.True(wasDrawn);
        Assert.InRange(driver.Screen.Grabs, 4, 50);
        Assert.Equal(0, driver.Screen.SpoiltPictures);
    }

    [Fact]
    public void Display_shows_frames_rate_queue_and_free_disk()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Press(Keys.J);
        var lines = new List<string>();
        for (int tick = 0; tick < 3 * TicksOfAFrame; tick++)
        {
            driver.Clock.Milliseconds += 50;
            driver.Tick();
            lines.AddRange(driver.Game.Texts);
        }

        // The free space is read on another thread.
        driver.Until(() => driver.Game.Texts.Any(text => text.Contains("free", StringComparison.Ordinal)));
        Assert.Matches(
            @"^REC  \d+ frames  \d+\.\d/s  0 discarded  queue \d+  \d+\.\d GB free(  1 minute of driving takes \d+(\.\d)?)?$",
            driver.Game.Texts[^1]
        );
        Assert.All(lines, line => Assert.InRange(line.Length, 1, 99));
    }

    [Fact]
    public void Display_states_how_long_a_minute_of_driving_takes()
    {
        // A frame is taken after each second tick of the running game, and needs some ticks of the frozen one.
        const double millisecondsOfATick = 20;
        const int ticks = 400;
        const double toleranceOfFirstFrame = 0.05;
        using var driver = new ScriptDriver("[Harvest]\nQueue = 1000\n");
        Street(driver.Game);
        driver.Press(Keys.J);
        int before = driver.Game.TimerMilliseconds;
        string line = string.Empty;
        for (int tick = 0; tick < ticks; tick++)
        {
            driver.Clock.Milliseconds += millisecondsOfATick;
            driver.Tick();
            driver.WaitForDisk();
            line = driver.Game.Texts.Count > 0 ? driver.Game.Texts[^1] : line;
        }

        double ratio = ticks * millisecondsOfATick / (driver.Game.TimerMilliseconds - before);
        string shown = Regex.Match(line, @"1 minute of driving takes (\d+(\.\d)?)").Groups[1].Value;
        Assert.InRange(
            double.Parse(shown, CultureInfo.InvariantCulture),
            ratio - 0.05 - (toleranceOfFirstFrame * ratio),
            ratio + 0.05 + (toleranceOfFirstFrame * ratio)
        );
    }

    [Fact]
    public void Failure_before_the_first_frame_leaves_no_folder()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Press(Keys.J);

        // The session is open, and its first frame is being read.
        driver.Game.Fault = native => native == Hash.GET_ENTITY_MATRIX ? new InvalidOperationException("The native is broken.") : null;
        driver.UntilMessage("The native is broken.");
        driver.Game.Fault = _ => null;
        driver.WaitForDisk();

        // The folder of the sessions was made for this one.
        Assert.False(Directory.Exists(driver.Output));
        Assert.Contains(
            driver.Game.Notifications,
            message => message.Contains("(0 frames; its empty folder is removed)", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Key_before_the_folder_is_open_ends_the_harvest()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Script.RaiseKeyUp(Keys.J);
        driver.Script.RaiseKeyUp(Keys.J);
        Assert.Contains("stopped before its first frame", driver.Game.Notifications[^1], StringComparison.Ordinal);
        driver.WaitForDisk();
        driver.Tick(TicksOfAFrame);
        Assert.Equal(0, driver.Screen.Grabs);

        driver.Press(Keys.J);
        driver.Tick(TicksOfAFrame);
        Assert.InRange(driver.Screen.Grabs, 1, TicksOfAFrame);
    }

    [Fact]
    public void Session_is_locked_while_it_is_recorded()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(5 * TicksOfAFrame);
        string session = Assert.Single(Directory.GetDirectories(driver.Output));

        Assert.Throws<FolderLockedException>(() => WriterLock.Take(session));

        driver.Press(Keys.J);
        driver.WaitForDisk();
        WriterLock.Take(session).Dispose();
        Assert.Equal([session], Directory.GetFileSystemEntries(driver.Output));
    }

    [Fact]
    public void Frame_key_harvests_single_frames_into_one_session()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        for (int press = 0; press < 3; press++)
        {
            driver.Press(Keys.K);
            driver.Tick(2 * TicksOfAFrame);
            driver.WaitForDisk();
        }

        string session = Assert.Single(Directory.GetDirectories(driver.Output));
        Assert.Equal(3, File.ReadLines(Path.Combine(session, "labels.jsonl")).Count());
    }

    [Fact]
    public void Display_failure_is_reported_once_and_the_harvest_continues()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Game.Fault = native => native == Hash.SET_TEXT_FONT ? new InvalidOperationException("No font.") : null;
        driver.Press(Keys.J);
        driver.Tick(5 * TicksOfAFrame);

        Assert.Equal(1, driver.Game.Calls.Count(native => native == Hash.SET_TEXT_FONT));
        Assert.Equal("GtaDataHarvester: The display failed: No font. More in GtaDataHarvester.log.", driver.Game.Notifications[^1]);
        Assert.InRange(driver.Screen.Grabs, 4, 50);
    }

    [Fact]
    public void Overlay_outlines_objects_to_label_until_the_key_is_pressed()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Press(Keys.I);
        driver.Press(Keys.L);

        // Two objects, four sides each. The car ahead is right in front of the camera: its box holds the middle of the window.
        Assert.Equal(8, driver.Game.Rectangles.Count);
        Box2D car = driver.Game.Rectangles.Take(4).Aggregate((all, side) => all.Union(side));
        Assert.True(car.Contains(new Vector2D(0.5, 0.5)));
        driver.Press(Keys.L);
        Assert.Empty(driver.Game.Rectangles);
    }

    [Fact]
    public void Restoring_the_view_ends_the_harvest()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(TicksOfAFrame);
        driver.Press(Keys.O);
        driver.Tick(2);

        Assert.Contains("The harvest ended", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.False(driver.Game.IsPaused);
    }

    [Fact]
    public void Refused_pictures_are_counted_and_reported_by_reason()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        driver.Screen.Refusal = "covered";
        driver.Press(Keys.J);
        driver.Tick(3 * TicksOfAFrame);
        driver.Press(Keys.J);

        Assert.Matches(@"The harvest ended: 0 frames, discarded: \d+ covered", driver.Game.Notifications[^1]);
    }

    [Fact]
    public void Rays_leave_no_script_handles_behind()
    {
        using var driver = new ScriptDriver();
        Street(driver.Game);
        SunkenCar(driver.Game);
        driver.Press(Keys.K);
        driver.Tick(2 * TicksOfAFrame);

        Assert.Contains(Hash.RELEASE_SCRIPT_GUID_FROM_ENTITY, driver.Game.Calls);
        Assert.Empty(driver.Game.LeakedScriptHandles);
    }

    /// <summary>A car with the player in it, another one ahead and someone on the pavement, all on the ground, looking north.</summary>
    internal static void Street(TestGame game)
    {
        game.PlayersVehicle = game.Add(Standing(PoolKind.Vehicles, "asea", new Vector3D(100, 200, 0.6)));
        game.Add(Standing(PoolKind.Vehicles, "premier", new Vector3D(100, 220, 0.6)));
        game.Add(Standing(PoolKind.Peds, "a_m_y_hipster_01", new Vector3D(104, 225, 1)));
    }

    /// <summary>A car whose lower half is under the ground, which is not an entity: rays to that half hit the ground.</summary>
    internal static void SunkenCar(TestGame game) => game.Add(Standing(PoolKind.Vehicles, "stanier", new Vector3D(96, 220, -0.25)));

    private static GameEntity Standing(PoolKind pool, string name, Vector3D place) =>
        new()
        {
            Pool = pool,
            Name = name,
            Pose = new Pose(place, Axes.Identity),
            Skeleton = pool == PoolKind.Peds ? new Skeleton(Enumerable.Repeat(place, Skeleton.Count)) : null,
        };
}
