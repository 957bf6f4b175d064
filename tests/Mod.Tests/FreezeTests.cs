using System.Text.Json;
using System.Windows.Forms;
using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>The two ways in which the game is frozen, and the trial that chooses between them.</summary>
public sealed class FreezeTests
{
    private const string Auto = "[Harvest]\nFreeze = Auto\n";
    private const double MetresPerFrame = 0.5;

    [Theory]
    [InlineData("Paused", Hash.SET_GAME_PAUSED, Hash.SET_TIME_SCALE)]
    [InlineData("TimeScale", Hash.SET_TIME_SCALE, Hash.SET_GAME_PAUSED)]
    public void Freeze_method_of_the_settings_is_the_only_one_used(string way, Hash used, Hash unused)
    {
        using ScriptDriver driver = Driving($"[Harvest]\nFreeze = {way}\n");
        driver.Press(Keys.J);
        driver.Tick(50);
        driver.Press(Keys.J);

        Assert.Contains(used, driver.Game.Calls);
        Assert.DoesNotContain(unused, driver.Game.Calls);
        Assert.InRange(driver.Labels().Length, 4, 50);
        Assert.False(driver.Game.IsFrozen);
    }

    [Theory]
    [InlineData(null, null, "paused")]
    [InlineData(FreezeMethod.Paused, null, "timeScale")]
    [InlineData(FreezeMethod.TimeScale, null, "paused")]
    [InlineData(null, FreezeMethod.Paused, "timeScale")]
    [InlineData(FreezeMethod.Paused, FreezeMethod.TimeScale, "paused")]
    public void Auto_tries_both_methods_and_the_session_records_the_findings(
        FreezeMethod? holdsCamera,
        FreezeMethod? letsTrafficGoOn,
        string expected
    )
    {
        using ScriptDriver driver = Driving(Auto);
        driver.Game.HoldsCamera = holdsCamera;
        driver.Game.LetsTrafficGoOn = letsTrafficGoOn;
        Vector3D mounted = HarvestUntilFrames(driver);

        JsonElement freezing = Session(driver).GetProperty("start").GetProperty("freezing");
        Assert.Equal(expected, freezing.GetProperty("used").GetString());
        Assert.Equal(
            ["paused", "timeScale"],
            freezing.GetProperty("tried").EnumerateArray().Select(tried => tried.GetProperty("method").GetString())
        );
        Assert.All(
            freezing.GetProperty("tried").EnumerateArray(),
            tried =>
            {
                FreezeMethod method = tried.GetProperty("method").GetString() == "paused" ? FreezeMethod.Paused : FreezeMethod.TimeScale;
                Assert.True(tried.GetProperty("sawMovement").GetBoolean());
                Assert.Equal(method == letsTrafficGoOn, tried.GetProperty("settleTicks").ValueKind == JsonValueKind.Null);
                Assert.Equal(
                    method == letsTrafficGoOn ? JsonValueKind.Null
                        : method == holdsCamera ? JsonValueKind.False
                        : JsonValueKind.True,
                    tried.GetProperty("movesCamera").ValueKind
                );
            }
        );
        Assert.Contains("Freeze = Auto: Paused: the world", driver.Log(), StringComparison.Ordinal);
        Assert.Equal(mounted, Assert.Single(driver.Game.Cameras).Value.Offset);
    }

    [Fact]
    public void Single_frames_after_the_first_reuse_the_findings()
    {
        using ScriptDriver driver = Driving(Auto);
        driver.Game.HoldsCamera = FreezeMethod.Paused;
        TakeOne(driver);
        int trials = driver.Game.Calls.Count(native => native == Hash.SET_GAME_PAUSED);
        Assert.NotEqual(0, trials);
        TakeOne(driver);

        Assert.Equal(trials, driver.Game.Calls.Count(native => native == Hash.SET_GAME_PAUSED));
        Assert.Equal(2, driver.Labels().Length);
    }

    [Theory]
    [InlineData(Keys.O)]
    [InlineData(Keys.J)]
    public void Interrupted_freeze_trial_restores_pause_and_time_scale(Keys key)
    {
        using ScriptDriver driver = Driving(Auto);
        driver.Press(Keys.J);
        driver.Until(() => driver.Game.TimeScale == 0);
        driver.Press(key);

        Assert.Equal(1, driver.Game.TimeScale);
        Assert.False(driver.Game.IsPaused);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Reload_during_a_trial_restores_pause_and_time_scale(bool isPaused)
    {
        using ScriptDriver driver = Driving(Auto);
        driver.Press(Keys.J);
        driver.Until(() => isPaused ? driver.Game.IsPaused : driver.Game.TimeScale == 0);
        driver.Reload();

        Assert.Equal(1, driver.Game.TimeScale);
        Assert.False(driver.Game.IsPaused);
    }

    /// <summary>A street on which the player's car and the one ahead drive north.</summary>
    internal static ScriptDriver Driving(string ini)
    {
        var driver = new ScriptDriver(ini);
        HarvestTests.Street(driver.Game);
        TestGame game = driver.Game;
        game.PassFrame = () =>
        {
            foreach (GameEntity vehicle in game.DoesTrafficMove ? game.Vehicles : [])
            {
                vehicle.Pose = vehicle.Pose with { Position = vehicle.Pose.Position + new Vector3D(0, MetresPerFrame, 0) };
            }
        };
        return driver;
    }

    private static void TakeOne(ScriptDriver driver)
    {
        const double longAfterTheLastMessage = 60_000;
        driver.Clock.Milliseconds += longAfterTheLastMessage;
        int before = driver.Game.Notifications.Count;
        driver.Press(Keys.K);
        driver.Until(() => driver.Game.Notifications.Skip(before).Any(message => message.Contains("1 frame", StringComparison.Ordinal)));
        driver.WaitForDisk();
    }

    /// <summary>Harvests some frames; returns where the camera was mounted before.</summary>
    private static Vector3D HarvestUntilFrames(ScriptDriver driver)
    {
        driver.Press(Keys.I);
        Vector3D mounted = Assert.Single(driver.Game.Cameras).Value.Offset;
        driver.Press(Keys.J);
        driver.Until(() => driver.Game.Texts.Any(text => text.Contains("REC  3 frames", StringComparison.Ordinal)));
        driver.Press(Keys.J);
        driver.WaitForDisk();
        return mounted;
    }

    private static JsonElement Session(ScriptDriver driver) =>
        JsonDocument
            .Parse(File.ReadAllText(Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "session.json")))
            .RootElement;
}
