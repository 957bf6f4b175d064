using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>After every fault the script works, the game runs, and the player got a message.</summary>
public sealed class FaultTests
{
    /// <summary>One in this many natives fails in the quick test; the heavy one takes the others.</summary>
    private const int QuickStep = 8;

    private static readonly Lazy<Hash[]> Played = new(PlayedNatives);

    public static TheoryData<Hash> SomeNatives => [.. Played.Value.Where((_, i) => i % QuickStep == 0)];

    public static TheoryData<Hash> OtherNatives => [.. Played.Value.Where((_, i) => i % QuickStep != 0)];

    [Theory]
    [MemberData(nameof(SomeNatives))]
    [Trait("Category", "Heavy")]
    public void Failing_native_is_reported_and_everything_recovers_after_it(Hash native) => FailAndRecover(native);

    [Theory]
    [MemberData(nameof(OtherNatives))]
    [Trait("Category", "Heavy")]
    public void Any_other_failing_native_is_reported_and_recovered_from(Hash native) => FailAndRecover(native);

    private static void FailAndRecover(Hash native)
    {
        using var driver = new ScriptDriver(Playthrough.Ini, faces: LightTests.TableOfOne);
        driver.Game.Fault = called => called == native ? new InvalidOperationException("The native is broken.") : null;
        Playthrough.Of(driver);
        Assert.Contains(driver.Game.Notifications, message => message.Contains("The native is broken.", StringComparison.Ordinal));
        Assert.All(driver.Game.Notifications, message => Assert.StartsWith("GtaDataHarvester: ", message, StringComparison.Ordinal));

        driver.Game.Fault = _ => null;
        driver.Press(Keys.O);
        driver.WaitForDisk();
        driver.Game.Notifications.Clear();
        int before = driver.Screen.Grabs;
        driver.Tick();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick();
        driver.WaitForDisk();
        driver.Tick(29);
        Assert.InRange(driver.Screen.Grabs, before + 1, before + 30);
        driver.Press(Keys.J);
        Assert.False(driver.Game.IsPaused);
        Assert.DoesNotContain(driver.Game.Notifications, message => message.Contains("failed", StringComparison.Ordinal));
    }

    [Fact]
    public void Every_native_of_the_mod_is_called_by_a_fault_scenario()
    {
        Hash[] elsewhere = [.. HidingTests.OwnNatives, .. RigTests.OwnNatives, .. ActorTests.OwnNatives];
        Assert.Empty(Enum.GetValues<Hash>().Except(Played.Value).Except(elsewhere));
    }

    [Fact]
    public void Entity_deleted_between_listing_and_reading_is_omitted()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        int doomed = driver.Game.HandleOf(driver.Game.Vehicles.Single(vehicle => vehicle.Name == "premier"));
        driver.Game.AfterListing = () => driver.Game.Entities.Remove(doomed);
        driver.Press(Keys.K);
        driver.Tick(20);
        driver.WaitForDisk();

        string label = Assert.Single(driver.Labels());
        Assert.DoesNotContain("premier", label, StringComparison.Ordinal);
        Assert.Contains("pedestrian", label, StringComparison.Ordinal);
    }

    [Fact]
    public void Entity_deleted_while_being_read_is_omitted()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        int doomed = driver.Game.HandleOf(driver.Game.Vehicles.Single(vehicle => vehicle.Name == "premier"));
        driver.Game.Fault = native =>
        {
            if (native == Hash.GET_ENTITY_MATRIX && driver.Game.IsPaused)
            {
                driver.Game.Entities.Remove(doomed);
            }

            return null;
        };
        driver.Press(Keys.K);
        driver.Tick(30);
        driver.WaitForDisk();

        Assert.DoesNotContain("premier", Assert.Single(driver.Labels()), StringComparison.Ordinal);
    }

    [Fact]
    public void Full_pool_of_script_handles_ends_the_harvest_with_a_message()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Game.ScriptHandlePoolIsFull = true;
        driver.Tick(20);

        Assert.Contains(
            "The harvest stopped: The fwScriptGuid pool is full. Restart the game, and remove mods that hold many",
            driver.Game.Notifications[^1],
            StringComparison.Ordinal
        );
        Assert.False(driver.Game.IsPaused);
    }

    [Fact]
    public void Abort_twice_during_a_harvest_restores_all_and_closes_session()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.NumPad0);
        driver.Tick(10);
        driver.Press(Keys.J);
        for (int tick = 0; tick < 100 && !driver.Game.IsPaused; tick++)
        {
            driver.Tick();
        }

        Assert.True(driver.Game.IsPaused);
        var other = new Thread(() =>
        {
            driver.Script.RaiseAborted();
            driver.Script.RaiseAborted();
        });
        other.Start();
        other.Join();

        Assert.False(driver.Game.IsPaused);
        Assert.Equal(-1, driver.Game.RenderingCamera);
        Assert.Empty(driver.Game.Cameras);
        Assert.DoesNotContain(driver.Game.Vehicles, vehicle => vehicle.Name == TestGame.Adder);
        string session = Assert.Single(Directory.GetDirectories(driver.Output));
        Assert.Contains("\"state\": \"complete\"", File.ReadAllText(Path.Combine(session, "session.json")), StringComparison.Ordinal);

        int calls = driver.Game.Calls.Count;
        driver.Tick(3);
        driver.Press(Keys.J);
        Assert.Equal(calls, driver.Game.Calls.Count);
    }

    [Fact]
    public void Keys_act_on_release()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Tick();
        int before = driver.Game.Calls.Count;
        for (int repeat = 0; repeat < 30; repeat++)
        {
            foreach (Keys key in ShippedKeys.All)
            {
                driver.Script.RaiseKeyDown(key);
            }
        }

        Assert.Equal(before, driver.Game.Calls.Count);
    }

    [Fact]
    public void Pause_menu_in_the_middle_of_a_frame_only_delays_it()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.K);
        driver.Tick();

        // The menu stops all scripts: frames go by without a tick of ours.
        for (int frame = 0; frame < 100; frame++)
        {
            driver.Game.NextFrame();
        }

        driver.Tick(20);
        driver.WaitForDisk();
        Assert.Single(driver.Labels());
        Assert.False(driver.Game.IsPaused);
    }

    [Fact]
    public void Loading_a_saved_game_closes_the_harvest_for_a_new_script()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(15);

        // The game sweeps its world away and the loader ends the scripts, in this order.
        driver.Game.Entities.Clear();
        driver.Game.Cameras.Clear();
        driver.Game.RenderingCamera = -1;
        driver.Reload();
        driver.Game.Entities[TestGame.Player] = new GameEntity
        {
            Pool = PoolKind.Peds,
            Name = "player_one",
            Pose = new Pose(default, Axes.Identity),
        };
        HarvestTests.Street(driver.Game);
        driver.Tick(3);
        Assert.False(driver.Game.IsPaused);
        driver.Press(Keys.I);
        Assert.Single(driver.Game.Cameras);
    }

    [Fact]
    public void Loading_a_saved_game_in_the_same_script_ends_the_harvest()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(15);
        driver.Game.Entities.Remove(driver.Game.PlayersVehicle);
        driver.Game.PlayersVehicle = 0;
        driver.Tick(2);

        Assert.Contains(
            driver.Game.Notifications,
            message => message.Contains("vehicle with the camera is gone", StringComparison.Ordinal)
        );
        Assert.Contains("The harvest ended", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.False(driver.Game.IsPaused);
    }

    [Fact]
    public void Model_that_never_loads_is_reported_after_a_while()
    {
        using var driver = new ScriptDriver();
        driver.Game.ModelsLoad = false;
        driver.Press(Keys.NumPad0);
        driver.Tick(50);
        Assert.Empty(driver.Game.Notifications);
        driver.Clock.Milliseconds += 11_000;
        driver.Tick(2);

        Assert.Contains("did not load the vehicle 'adder'", Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);
        driver.Game.ModelsLoad = true;
        driver.Press(Keys.NumPad0);
        driver.Tick(10);
        Assert.Single(driver.Game.Vehicles);
    }

    [Fact]
    public void Folder_that_cannot_be_created_is_reported()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        File.WriteAllText(driver.Output, "a file where the folder should be");
        driver.Press(Keys.J);

        Assert.Contains("The harvest failed", driver.Game.Notifications[^1], StringComparison.Ordinal);
        File.Delete(driver.Output);
        driver.Press(Keys.J);
        driver.Tick(20);
        Assert.True(Directory.Exists(driver.Output));
    }

    [Fact]
    public void Write_errors_after_a_harvest_are_reported()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.K);
        Directory.CreateDirectory(Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "labels.jsonl"));

        driver.UntilMessage("cannot be written");

        // That session is not resumed.
        driver.Game.Notifications.Clear();
        driver.Press(Keys.K);
        driver.UntilMessage("The harvest ended: 1 frame");
        driver.WaitForDisk();
        driver.Tick();
        Assert.DoesNotContain(driver.Game.Notifications, message => message.Contains("cannot be written", StringComparison.Ordinal));
        Assert.Equal(2, Directory.GetDirectories(driver.Output).Length);
    }

    private static Hash[] PlayedNatives()
    {
        using var driver = new ScriptDriver(Playthrough.Ini, faces: LightTests.TableOfOne);
        Playthrough.Of(driver);
        return driver.Game.Calls.Distinct().Order().ToArray();
    }
}
