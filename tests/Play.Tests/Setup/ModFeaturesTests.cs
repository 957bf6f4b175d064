using Harvester.Capture.Storage;
using Harvester.Play.Features;
using Harvester.Play.Settings;
using Harvester.Play.Setup;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Setup;

public sealed class ModFeaturesTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("features").FullName;
    private readonly List<string> _told = [];
    private readonly IdleGame _game = new();
    private ModFeatures? _features;
    private ModSetup? _setup;

    public void Dispose()
    {
        _features?.All.Finish();
        SpinWait.SpinUntil(() => _features is not { All.IsBusy: true }, TimeSpan.FromMinutes(1));
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Making_the_features_does_not_call_the_game()
    {
        Make();

        Assert.Empty(_game.CalledMembers);
    }

    [Fact]
    public void Drives_are_recorded_only_if_the_settings_ask_for_it()
    {
        Assert.Null(Make().Drive.Recording);
        Assert.NotNull(Make("[Bridge]\nRecord = On\n").Drive.Recording);
    }

    [Fact]
    public void Settings_choose_how_the_game_is_frozen()
    {
        Make("[Harvest]\nFreeze = TimeScale\n");

        Assert.Equal(Capture.Ports.FreezeMethod.TimeScale, _game.Time.Method);
    }

    [Fact]
    public void Plan_waits_while_a_client_drives()
    {
        ModFeatures features = Make();
        features.Drive.Toggle();
        Assert.True(features.Drive.IsOn, Told);

        Assert.Equal("A client drives: end that first.", features.Plan.Obstacle());
    }

    [Fact]
    public void Self_test_and_calibration_wait_while_a_client_drives()
    {
        ModFeatures features = Make();
        features.Drive.Toggle();
        features.SelfTest.Toggle();
        features.Calibration.Toggle();

        Assert.False(features.SelfTest.IsOn);
        Assert.False(features.Calibration.IsOn);
        Assert.Equal(2, _told.Count(message => message.Contains("A client drives: end that first.", StringComparison.Ordinal)));
    }

    [Fact]
    public void Paint_without_its_roads_is_not_used()
    {
        Make("[Roads]\nPaint = paint.csv\n");

        Assert.Contains(_setup!.Folder.Complaints, text => text.Contains("Paint under [Roads] is not used", StringComparison.Ordinal));
        Assert.DoesNotContain(_setup.Player.LaneSettings, setting => setting.Key == "paint");
    }

    [Fact]
    public void Client_waits_while_a_harvest_runs()
    {
        ModFeatures features = Make();
        features.Harvest.Toggle();
        Assert.True(features.Harvest.IsOn, Told);
        features.Drive.Toggle();

        Assert.False(features.Drive.IsOn);
        Assert.Contains("End the harvest first.", Told, StringComparison.Ordinal);
    }

    [Fact]
    public void Rig_that_cannot_be_read_keeps_harvests_off()
    {
        ModFeatures features = Make("[Harvest]\nRig = missing.json\n");
        features.Harvest.Toggle();

        Assert.False(features.Harvest.IsOn);
        Assert.Contains("there is no file missing.json", Told, StringComparison.Ordinal);
    }

    [Fact]
    public void Finishing_removes_the_camera()
    {
        ModFeatures features = Make();
        features.Mount.Mount();
        Assert.True(features.Mount.IsMounted, Told);
        features.All.Finish();

        Assert.False(features.Mount.IsMounted);
        Assert.Contains("Remove", _game.CalledMembers);
    }

    private string Told => string.Join('\n', _told);

    private ModFeatures Make(string ini = "")
    {
        _features?.All.Finish();
        File.WriteAllText(Path.Combine(_folder, "GtaDataHarvester.ini"), ini);
        var folder = new ModFolder(_folder);
        var clock = new TestClock();
        _setup = new ModSetup
        {
            Folder = folder,
            Player = PlayerSettings.Read(folder.Settings, _folder),
            Messages = new PlayerMessages(_folder, _told.Add, clock),
            Screen = _game.Screen,
            Clock = clock,
            RealTime = clock,
            GraphicsFile = Path.Combine(_folder, "settings.xml"),
            Origin = new SessionOrigin { Game = "idle", Tool = "test" },
        };
        return _features = new ModFeatures(_setup, _game);
    }
}
