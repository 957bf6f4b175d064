using System.Windows.Forms;
using Harvester.Datasets.Diagnosis;

namespace Harvester.Mod.Tests;

/// <summary>GTA V pauses without the focus: no script gets a tick until it is back.</summary>
public sealed class FocusLossTests
{
    private const double MillisecondsAway = 12_300;

    [Fact]
    public void Gap_during_a_harvest_is_shown_with_its_length_and_remedy()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Tick(20);
        LoseFocus(driver);

        Assert.Contains(
            driver.Game.Notifications,
            shown =>
                shown.Contains("No tick for 12.3 s: the game was paused. Switch off Pause Game On Focus Loss", StringComparison.Ordinal)
        );
        driver.Press(Keys.J);
        Assert.Contains("The game stopped for 12.3 s while a harvest, a drive or a plan was running.", CausesIn(driver));
    }

    [Fact]
    public void Gap_while_nothing_runs_is_only_logged()
    {
        using var driver = new ScriptDriver();
        driver.Tick(20);
        LoseFocus(driver);

        Assert.Empty(driver.Game.Notifications);
        Assert.Contains("No tick for 12.3 s: the game was paused or loading.", driver.Log(), StringComparison.Ordinal);
        Assert.Empty(CausesIn(driver));
    }

    [Fact]
    public void Game_that_goes_on_without_the_focus_has_no_gap()
    {
        using var driver = new ScriptDriver();
        driver.Game.PausesWithoutFocus = false;
        driver.Tick();
        LoseFocus(driver);
        driver.Tick();

        Assert.DoesNotContain("No tick", driver.Log(), StringComparison.Ordinal);
    }

    [Fact]
    public void Setting_that_pauses_the_game_is_named_by_the_doctor()
    {
        using var driver = new ScriptDriver();
        File.WriteAllText(driver.GraphicsFile, "<Settings><video><PauseOnFocusLoss value=\"1\" /></video></Settings>");
        GraphicsAdviceTests.UntilRead(driver);

        Assert.Equal(
            ["The game stops while another window has the focus, so a program that drives gets no frames then."],
            CausesIn(driver)
        );
    }

    /// <summary>The window loses the focus for a while and gets it back, with ticks as the game gives them.</summary>
    private static void LoseFocus(ScriptDriver driver)
    {
        const int pieces = 100;
        driver.Game.HasFocus = false;
        for (int i = 0; i < pieces; i++)
        {
            driver.Clock.Milliseconds += MillisecondsAway / pieces;
            driver.Tick();
        }

        driver.Game.HasFocus = true;
        driver.Tick();
    }

    private static IEnumerable<string> CausesIn(ScriptDriver driver)
    {
        driver.WaitForDisk();
        return Doctor.Examine(driver.Folder).Findings.Select(finding => finding.Cause);
    }
}
