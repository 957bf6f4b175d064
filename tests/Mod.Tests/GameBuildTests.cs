using System.Text.Json;
using System.Windows.Forms;
using Harvester.Geometry;

namespace Harvester.Mod.Tests;

public sealed class GameBuildTests
{
    [Theory]
    [InlineData("GTA5.exe", "Legacy")]
    [InlineData("GTA5_Enhanced.exe", "Enhanced")]
    public void Session_records_edition_build_and_api(string program, string edition)
    {
        using var driver = new ScriptDriver(prepare: game => game.Build = new GameBuild(program, new Version(1, 0, 2699, 16)));
        CameraMountTests.SitInCar(driver.Game, Axes.Identity);
        driver.Press(Keys.K);
        driver.Until(() => driver.Screen.Grabs > 0 && Directory.Exists(driver.Output));
        driver.Tick(20);
        driver.WaitForDisk();
        string session = Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "session.json");
        JsonElement json = JsonDocument.Parse(File.ReadAllText(session)).RootElement;

        Assert.Equal($"GTA V {edition} 1.0.2699.16", json.GetProperty("game").GetString());
        JsonElement settings = json.GetProperty("settings");
        Assert.Equal(edition, settings.GetProperty("gameEdition").GetString());
        Assert.Equal("1.0.2699.16", settings.GetProperty("gameBuild").GetString());
        Assert.Equal("3.6.0.0", settings.GetProperty("scriptApi").GetString());
    }

    [Theory]
    [InlineData("GTA5.exe", 2060, true, false)]
    [InlineData("GTA5.exe", 2189, false, false)]
    [InlineData("GTA5.exe", 3179, false, false)]
    [InlineData("GTA5.exe", 3258, false, true)]
    [InlineData("GTA5_Enhanced.exe", 811, false, false)]
    public void Problems_of_a_build_follow_its_file_version(string program, int build, bool noMount, bool noList)
    {
        var game = new GameBuild(program, new Version(1, 0, build, 0));

        Assert.Equal(noMount, game.MountProblem is not null);
        Assert.Equal(noList, game.ListProblem is not null);
    }

    [Fact]
    public void Unreadable_build_number_is_unknown_and_accepted()
    {
        var game = new GameBuild("GTA5.exe", null);

        Assert.Equal("GTA V Legacy unknown", game.Name);
        Assert.Null(game.MountProblem);
        Assert.Null(game.ListProblem);
    }
}
