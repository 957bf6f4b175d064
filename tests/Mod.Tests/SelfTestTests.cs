using System.Windows.Forms;
using Harvester.Capture.Ports;
using Harvester.Capture.SelfTests;
using Harvester.Datasets.Diagnosis;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Faces;
using Harvester.Sessions.SelfTests;
using Harvester.Simulation.Settings;

namespace Harvester.Mod.Tests;

/// <summary>The self-test by its key: the zip, the messages, and what is given back.</summary>
public sealed class SelfTestTests
{
    private const string Ini = "[Harvest]\nWidth = 320\nHeight = 240\n";

    [Fact]
    [Trait("Category", "Heavy")]
    public void Zip_is_written_and_the_doctor_reads_it()
    {
        var scene = new SimulatedScene(new SimulationOptions { Seed = 9 }, FaceTable.Empty);
        using var driver = new ScriptDriver(Ini, scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock);
        driver.Press(Keys.T);
        driver.UntilMessage("The self-test ended");
        driver.Tick(2);

        string zip = Assert.Single(Directory.GetFiles(driver.Folder, "selftest-*.zip", SearchOption.AllDirectories));
        Assert.Equal(SelfTestChecks.All, Doctor.Examine(zip).SelfTest!.Lines.Select(line => line.Check));
        AssertGivenBack(driver);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Clear_answers_are_written_to_the_ini_and_a_copy_kept()
    {
        using ScriptDriver driver = FreezeTests.Driving(Ini);
        driver.Game.HoldsCamera = FreezeMethod.Paused;
        string ini = Path.Combine(driver.Folder, "GtaDataHarvester.ini");
        string before = File.ReadAllText(ini);
        driver.Press(Keys.T);
        driver.UntilMessage("The self-test ended");
        driver.Tick(2);

        string zip = Assert.Single(Directory.GetFiles(driver.Folder, "selftest-*.zip", SearchOption.AllDirectories));
        IReadOnlyList<string> changes = Doctor.Examine(zip).SelfTest!.Changes;
        string after = File.ReadAllText(ini);
        Assert.NotEmpty(changes);
        Assert.All(changes, change => Assert.Contains(change, after, StringComparison.Ordinal));
        Assert.Equal(before, File.ReadAllText(ini + ".before-selftest"));
        Assert.Contains(driver.Game.Notifications, text => text.Contains("was written to the ini", StringComparison.Ordinal));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Second_press_ends_it_and_gives_everything_back()
    {
        var scene = new SimulatedScene(new SimulationOptions { Seed = 9 }, FaceTable.Empty);
        using var driver = new ScriptDriver(Ini, scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock);
        driver.Press(Keys.T);
        driver.Until(() => driver.Game.IsFrozen);
        driver.Press(Keys.J);
        Assert.Contains(driver.Game.Notifications, text => text.Contains("The self-test is running", StringComparison.Ordinal));
        driver.Press(Keys.T);
        driver.Tick(2);

        Assert.Contains(driver.Game.Notifications, text => text.Contains("The self-test was stopped", StringComparison.Ordinal));
        Assert.Empty(Directory.GetFiles(driver.Folder, "selftest-*.zip", SearchOption.AllDirectories));
        AssertGivenBack(driver);
    }

    private static void AssertGivenBack(ScriptDriver driver)
    {
        Assert.False(driver.Game.IsFrozen);
        Assert.True(driver.Game.IsRadarOn);
        Assert.True(driver.Game.IsHudOn);
        Assert.Empty(driver.Game.Balls);
    }
}
