using System.Windows.Forms;

namespace Harvester.Mod.Tests;

/// <summary>Single frames that are asked for faster than they are taken.</summary>
public sealed class SingleFrameTests
{
    private const int MoreTicksThanAllFrames = 200;

    [Theory]
    [InlineData(2)]
    [InlineData(4)]
    public void Each_press_of_the_key_gives_a_frame(int presses)
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        PressAtOnce(driver, presses);
        TickAndWait(driver);

        Assert.Equal(presses, driver.Labels().Length);
        Assert.DoesNotContain(driver.Game.Notifications, shown => shown.Contains("running already", StringComparison.Ordinal));
    }

    [Fact]
    public void Restored_camera_cancels_the_frames_that_wait()
    {
        using var driver = new ScriptDriver();
        HarvestTests.Street(driver.Game);
        PressAtOnce(driver, 3);
        driver.Until(() => driver.Game.Notifications.Any(shown => shown.Contains("ended: 1 frame", StringComparison.Ordinal)));
        driver.Press(Keys.O);
        TickAndWait(driver);

        Assert.InRange(driver.Labels().Length, 1, 2);
        Assert.Empty(driver.Game.Cameras);
    }

    private static void PressAtOnce(ScriptDriver driver, int presses)
    {
        for (int press = 0; press < presses; press++)
        {
            driver.Script.RaiseKeyDown(Keys.K);
            driver.Script.RaiseKeyUp(Keys.K);
        }
    }

    private static void TickAndWait(ScriptDriver driver)
    {
        for (int tick = 0; tick < MoreTicksThanAllFrames; tick++)
        {
            driver.WaitForDisk();
            driver.Tick();
        }

        driver.WaitForDisk();
    }
}
