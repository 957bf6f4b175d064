using System.Windows.Forms;
using GTA.Native;
using Harvester.Geometry.Cameras;
using Harvester.Mod.Tests.Games;
using Harvester.Play.Features;
using Harvester.Play.Settings;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Mod.Tests;

public sealed class CalibrationTests
{
    private const string Ini = "[Harvest]\nWidth = 400\nHeight = 300\n[Lens]\n; mine\nK2 = 0\nMaxError = 0.5\n";

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_refuses_a_wrong_lens_until_it_is_calibrated()
    {
        var options = new SimulationOptions { Seed = 9, Lens = new RenderLens(1.008, 0, 0, -0.02, 0) };
        var scene = new SimulatedScene(options, FaceTable.Empty);
        using var driver = new ScriptDriver(Ini, scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock);
        driver.Press(Keys.J);
        driver.UntilMessage("The camera model is off by");
        Assert.False(driver.Game.IsPaused);
        driver.WaitForDisk();

        driver.Press(Keys.NumPad1);
        driver.Tick();
        Assert.True(driver.Game.IsHudHidden);
        driver.UntilMessage("Calibrated: the error was");
        driver.WaitForDisk();
        Assert.False(driver.Game.IsPaused);
        driver.Tick();
        Assert.Empty(driver.Game.Balls);
        Lens lens = HarvestSettings.Read(new ModFolder(driver.Folder).Settings).Lens;
        Assert.InRange(lens.FocalScale, 1.006, 1.010);
        Assert.InRange(lens.K1, -0.025, -0.015);
        Assert.Contains("; mine", File.ReadAllText(Path.Combine(driver.Folder, "GtaDataHarvester.ini")), StringComparison.Ordinal);

        // The check at the start of the harvest is the judge of the lens: half a pixel.
        driver.Press(Keys.K);
        driver.UntilMessage("The harvest ended: 1 frame");
    }

    [Fact]
    public void Single_frame_with_a_wrong_lens_is_refused_every_time()
    {
        var options = new SimulationOptions { Seed = 9, Lens = new RenderLens(1.008, 0, 0, -0.02, 0) };
        var scene = new SimulatedScene(options, FaceTable.Empty);
        using var driver = new ScriptDriver(Ini, scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock);
        for (int press = 0; press < 2; press++)
        {
            Assert.Contains("The camera model is off by", EndOfOneFrame(driver), StringComparison.Ordinal);
        }

        Assert.False(Directory.Exists(driver.Output));
    }

    [Fact]
    public void Single_frames_after_a_calibration_start_a_new_session()
    {
        var scene = new SimulatedScene(new SimulationOptions { Seed = 9 }, FaceTable.Empty);
        using var driver = new ScriptDriver(Ini, scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock);
        Assert.Contains("ended: 1 frame", EndOfOneFrame(driver), StringComparison.Ordinal);
        driver.Press(Keys.NumPad1);
        driver.UntilMessage("Calibrated: the error was");
        Assert.Contains("ended: 1 frame", EndOfOneFrame(driver), StringComparison.Ordinal);
        Assert.Contains("ended: 1 frame", EndOfOneFrame(driver), StringComparison.Ordinal);

        int[] frames =
        [
            .. Directory
                .GetDirectories(driver.Output, "singles*")
                .Order(StringComparer.Ordinal)
                .Select(session => File.ReadLines(Path.Combine(session, "labels.jsonl")).Count()),
        ];
        Assert.Equal([1, 2], frames);

        // The second session records the error of the model, though its second frame was not checked again.
        string header = File.ReadAllText(
            Path.Combine(Directory.GetDirectories(driver.Output).Order(StringComparer.Ordinal).Last(), "session.json")
        );
        Assert.Matches("\"cameraErrorPixels\": [0-9]", header);
    }

    [Fact]
    public void Harvest_waits_for_a_calibration_and_the_key_stops_it()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.I);
        driver.Press(Keys.NumPad1);
        driver.Press(Keys.J);
        Assert.Contains("The calibration is running", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.True(driver.Game.IsPaused);
        driver.Press(Keys.NumPad1);

        Assert.Contains("The calibration was stopped", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.False(driver.Game.IsPaused);
        Assert.False(Directory.Exists(driver.Output));
    }

    [Fact]
    public void Calibration_without_the_mounted_camera_reports_it()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        string ini = File.ReadAllText(Path.Combine(driver.Folder, "GtaDataHarvester.ini"));
        driver.Press(Keys.NumPad1);
        driver.Tick(100);

        Assert.Contains("Mount the camera first", Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);
        Assert.Empty(driver.Game.Cameras);
        Assert.DoesNotContain(Hash.SET_GAME_PAUSED, driver.Game.Calls);
        Assert.DoesNotContain(Hash.DRAW_MARKER, driver.Game.Calls);
        Assert.Equal(ini, File.ReadAllText(Path.Combine(driver.Folder, "GtaDataHarvester.ini")));
    }

    [Fact]
    public void Calibration_without_markers_reports_it_and_changes_nothing()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        string ini = File.ReadAllText(Path.Combine(driver.Folder, "GtaDataHarvester.ini"));
        driver.Press(Keys.I);
        driver.Press(Keys.NumPad1);
        driver.UntilMessage("The lens cannot be determined");

        Assert.Equal(ini, File.ReadAllText(Path.Combine(driver.Folder, "GtaDataHarvester.ini")));
        Assert.False(driver.Game.IsPaused);
    }

    [Fact]
    public void Harvest_without_visible_markers_warns_that_it_is_unchecked()
    {
        using var driver = new ScriptDriver("[Lens]\nMaxError = 1\n");
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.K);
        driver.UntilMessage("The harvest ended: 1 frame");

        Assert.Contains(
            driver.Game.Notifications,
            message => message.Contains("The camera model was not checked: none of 20 markers was visible", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Single_frames_are_harvested_unchecked_if_no_check_works()
    {
        using var driver = new ScriptDriver("[Lens]\nMaxError = 1\n");
        HarvestTests.Street(driver.Game);
        for (int press = 0; press < 2; press++)
        {
            Assert.Contains("ended: 1 frame", EndOfOneFrame(driver), StringComparison.Ordinal);
            Assert.Contains(driver.Game.Notifications, message => message.Contains("was not checked", StringComparison.Ordinal));
        }

        string session = Assert.Single(Directory.GetDirectories(driver.Output));
        Assert.Equal(2, File.ReadLines(Path.Combine(session, "labels.jsonl")).Count());
    }

    /// <summary>Harvests one frame; returns the message about its end.</summary>
    private static string EndOfOneFrame(ScriptDriver driver)
    {
        driver.Press(Keys.O);
        driver.Game.Notifications.Clear();
        driver.Press(Keys.K);
        driver.Until(() =>
            driver.Game.Notifications.Any(message =>
                message.Contains("The harvest ended", StringComparison.Ordinal)
                || message.Contains("The camera model is off", StringComparison.Ordinal)
            )
        );
        driver.WaitForDisk();
        return driver.Game.Notifications[^1];
    }
}
