using System.Windows.Forms;

namespace Harvester.Mod.Tests;

/// <summary>Texts that contain the game's markup are shown as they are meant; the test game reports any that is not.</summary>
public sealed class GameTextTests
{
    [Fact]
    public void Markup_in_a_message_is_shown_as_text()
    {
        using var driver = new ScriptDriver("[TestCar]\nModel = ~r~car\n");
        driver.Press(Keys.NumPad0);

        Assert.Contains("'\u02DCr\u02DCcar'", Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);
        Assert.Contains("'~r~car'", driver.Log(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("", "")]
    [InlineData("C:\\Users\\MAXMUS~1", "C:\\Users\\MAXMUS\u02DC1")]
    [InlineData("~r~~n~", "\u02DCr\u02DC\u02DCn\u02DC")]
    public void Text_keeps_all_but_the_markup(string text, string shown) => Assert.Equal(shown, GameText.Plain(text));
}
