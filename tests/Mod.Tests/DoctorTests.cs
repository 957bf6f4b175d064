using System.Windows.Forms;
using GTA.Native;
using Harvester.Datasets.Diagnosis;

namespace Harvester.Mod.Tests;

/// <summary>What the mod really logs, read by the doctor: the texts of both must go together.</summary>
public sealed class DoctorTests
{
    private const int TicksOfSomeFrames = 50;

    [Fact]
    public void Run_without_a_problem_has_no_finding()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.L);
        Harvest(driver);
        driver.Press(Keys.L);
        driver.Press(Keys.O);
        driver.Reload();
        driver.Tick();

        Assert.Contains("The harvest: off after", driver.Log(), StringComparison.Ordinal);
        Assert.Contains("The harvest asked of the game: ", driver.Log(), StringComparison.Ordinal);
        Assert.Empty(FindingsOf(driver, allRuns: true));
    }

    [Fact]
    public void Refused_pictures_are_explained()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Screen.Refusal = "covered";
        Harvest(driver);
        driver.Reload();

        Assert.Equal(["Something covered the game's window."], FindingsOf(driver));
    }

    [Fact]
    public void Wrong_setting_is_explained()
    {
        using var driver = new ScriptDriver("[Harvest]\nRate = fast\n");
        driver.Tick(2);

        Assert.Equal(["A setting in GtaDataHarvester.ini is wrong; its default is used."], FindingsOf(driver));
    }

    [Fact]
    public void Feature_that_fails_is_named()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Game.Fault = native => native == Hash.DRAW_RECT ? new InvalidOperationException("No rectangle.") : null;
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        driver.Reload();

        Assert.Equal(["The overlay failed unexpectedly."], FindingsOf(driver));
    }

    [Fact]
    public void Harvest_in_which_the_game_ends_is_named()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(TicksOfSomeFrames);

        Assert.Contains("The log ends while 'The ", Assert.Single(FindingsOf(driver)), StringComparison.Ordinal);
    }

    private static void Harvest(ScriptDriver driver)
    {
        driver.Press(Keys.J);
        driver.Tick(TicksOfSomeFrames);
        driver.Press(Keys.J);
        driver.Tick();
    }

    private static IReadOnlyList<string> FindingsOf(ScriptDriver driver, bool allRuns = false)
    {
        driver.WaitForDisk();
        return [.. Doctor.Examine(driver.Folder, allRuns).Findings.Select(finding => finding.Cause)];
    }
}
