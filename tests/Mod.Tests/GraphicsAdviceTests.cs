using Harvester.Datasets.Diagnosis;

namespace Harvester.Mod.Tests;

/// <summary>The mod reads the game's settings.xml and warns of what harms pictures and labels.</summary>
public sealed class GraphicsAdviceTests
{
    [Fact]
    public void Harmful_settings_are_shown_once_and_named_by_the_doctor()
    {
        using var driver = new ScriptDriver();
        File.WriteAllText(
            driver.GraphicsFile,
            "<Settings><graphics><MSAA value=\"4\" /><DoF value=\"true\" />"
                + "<MotionBlurStrength value=\"0.500000\" /></graphics></Settings>"
        );
        UntilRead(driver);
        driver.Tick(10);

        const string found =
            "Settings of the game harm pictures and labels: "
            + "Motion Blur Strength is 0.5, In-Game Depth Of Field Effects is on, MSAA is 4.";
        Assert.Contains(found, Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);
        Assert.Equal([found], Doctor.Examine(driver.Folder).Findings.Select(finding => finding.Cause));
    }

    [Fact]
    public void Recommended_settings_are_not_complained_about()
    {
        using var driver = new ScriptDriver();
        File.WriteAllText(
            driver.GraphicsFile,
            "<Settings><MSAA value=\"0\" /><TXAA_Enabled value=\"false\" /><DoF value=\"false\" /><PostFX value=\"0\" />"
                + "<MotionBlurStrength value=\"0.000000\" /><PauseOnFocusLoss value=\"0\" /></Settings>"
        );
        UntilRead(driver);

        Assert.Empty(driver.Game.Notifications);
        Assert.Empty(Doctor.Examine(driver.Folder).Findings);
    }

    [Theory]
    [InlineData(null)]
    [InlineData("<Settings><MSAA value=")]
    [InlineData("<!DOCTYPE s [<!ENTITY a SYSTEM \"file:///etc/passwd\">]><s>&a;</s>")]
    public void Unreadable_file_is_one_line_in_the_log(string? text)
    {
        using var driver = new ScriptDriver();
        if (text is not null)
        {
            File.WriteAllText(driver.GraphicsFile, text);
        }

        UntilRead(driver);

        Assert.Empty(driver.Game.Notifications);
        Assert.Single(driver.Log().Split('\n'), line => line.Contains("settings.xml was not read: ", StringComparison.Ordinal));
    }

    /// <summary>Lets the mod read the file and say what it found.</summary>
    internal static void UntilRead(ScriptDriver driver)
    {
        driver.Tick();
        driver.WaitForDisk();
        driver.Tick();
        driver.WaitForDisk();
    }
}
