using Harvester.Play.Settings;
using Harvester.Play.Tapes;
using Harvester.Sessions.Text;

namespace Harvester.Play.Tests.Tapes;

public sealed class TapeSettingsTests
{
    [Theory]
    [InlineData("Folder = sessions")]
    [InlineData("folder=sessions")]
    [InlineData("Width = C:\\Users\\anna")]
    [InlineData("Width = /home/anna")]
    [InlineData("Width = %USERPROFILE%")]
    [InlineData("Width = ..")]
    [InlineData("Plate = ANNA")]
    [InlineData("Token = secret")]
    [InlineData("; my own comment")]
    [InlineData("not a setting")]
    [InlineData("[C:\\]")]
    public void Lines_that_may_name_something_are_left_out(string line) =>
        Assert.Equal("[Harvest]\nRate = 5\n", Filtered($"[Harvest]\r\n{line}\r\n  Rate = 5\r\n"));

    [Fact]
    public void Filtered_settings_are_read_as_before()
    {
        const string settings = "[Keys]\nHarvest = F9\n[Harvest]\nWidth = 640\nFreeze = Auto\n[Lens]\nK1 = -0.02\n";

        Assert.Equal(settings, Filtered(settings));
        Assert.Equal(Read(settings), Read(Filtered(settings)));
    }

    private static string Filtered(string settings)
    {
        using var reader = new StringReader(settings);
        return TapeSettings.Filter(reader);
    }

    private static PlayerSettings Read(string settings)
    {
        using var reader = new StringReader(settings);
        return PlayerSettings.Read(IniFile.Read(reader), "mod");
    }
}
