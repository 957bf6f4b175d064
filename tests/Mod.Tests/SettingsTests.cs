using System.Windows.Forms;
using Harvester.Play.Features;
using Harvester.Play.Settings;
using Harvester.Sessions.Text;

namespace Harvester.Mod.Tests;

public sealed class SettingsTests
{
    [Fact]
    public void Bad_value_is_reported_with_its_line_and_the_default_is_used()
    {
        using var driver = new ScriptDriver("[Keys]\nSpawnTestCar = Banana\n");
        Assert.Empty(driver.Game.Notifications);
        driver.Tick(2);

        Assert.Equal(
            "GtaDataHarvester: GtaDataHarvester.ini: Line 2: SpawnTestCar = Banana is not a key, such as NumPad0, I or F9; the default is "
                + "used.",
            Assert.Single(driver.Game.Notifications)
        );
        driver.Press(Keys.NumPad0);
        driver.Tick(10);
        Assert.Single(driver.Game.Vehicles);
    }

    [Fact]
    public void Keys_can_be_changed()
    {
        using var driver = new ScriptDriver("[Keys]\nSpawnTestCar = F9\n");
        driver.Press(Keys.NumPad0);
        driver.Tick(10);
        Assert.Empty(driver.Game.Vehicles);

        driver.Press(Keys.F9);
        driver.Tick(10);
        Assert.Single(driver.Game.Vehicles);
    }

    [Fact]
    public void First_tick_logs_versions_system_window_and_changed_settings()
    {
        using var driver = new ScriptDriver(
            "[Camera]\nVerticalFov = 60\n[Keys]\nHarvest = F4\nOverlay = L\n[Bridge]\nTakeBackKeys = W, A, S, D, Space\n"
        );
        driver.Tick(3);

        Assert.Matches(
            @"^(?<time>\d{4}-\d\d-\d\d \d\d:\d\d:\d\d )GtaDataHarvester \d+(\.\d+){3}, API 3\.6\.0\.0, GTA V Legacy 1\.0\.3179\.0\.\s+"
                + @"\S+ \S+ System: \S.*, runtime \d.*\.\s+"
                + @"\S+ \S+ Window: 1920 x 1080, borderless, 96 dpi\.\s+"
                + @"\S+ \S+ Changed settings: \[Camera\] VerticalFov = 60; \[Keys\] Harvest = F4; \[Harvest\] Folder = out; \[Harvest\] "
                + @"ProbeLag = Off; \[Harvest\] Rate = 10; \[Harvest\] CheckDisplay = Off; "
                + @"\[Harvest\] Freeze = Paused; \[Lens\] MaxError = 0\.\s*$",
            driver.Log()
        );
    }

    [Fact]
    public void Shipped_file_is_valid_and_states_the_defaults()
    {
        using var folder = new TemporaryFolder();
        File.Copy(
            Path.Combine(BuiltMod.RepositoryRoot, "src", "Harvester.Mod", "GtaDataHarvester.ini"),
            Path.Combine(folder.Path, "GtaDataHarvester.ini")
        );
        IniFile shipped = new ModFolder(folder.Path).Settings;
        IniFile empty = IniFile.Read(TextReader.Null);

        Assert.Equal(PlayerSettings.Read(empty, folder.Path), PlayerSettings.Read(shipped, folder.Path));
        Assert.Empty(shipped.Changes);
        (string Name, Keys Key)[] keys =
        [
            ("SpawnTestCar", Keys.NumPad0),
            ("MountCamera", Keys.I),
            ("RestoreCamera", Keys.O),
            ("Harvest", Keys.J),
            ("OneFrame", Keys.K),
            ("Overlay", Keys.L),
            ("Calibrate", Keys.NumPad1),
            ("RoadSurvey", Keys.U),
            ("PaintSurvey", Keys.End),
            ("SpaceSurvey", Keys.Multiply),
            ("MarkCorner", Keys.NumPad2),
            ("NextName", Keys.NumPad3),
            ("KeepFace", Keys.Y),
            ("UnknownModels", Keys.Divide),
            ("Drive", Keys.N),
            ("Plan", Keys.Decimal),
            ("SelfTest", Keys.T),
        ];
        Assert.All(keys, key => Assert.Equal(key.Key, shipped.Choice("Keys", key.Name, Keys.None, "a key")));
        Assert.Equal([Keys.W, Keys.A, Keys.S, Keys.D, Keys.Space], shipped.Choices<Keys>("Bridge", "TakeBackKeys", [], "keys"));
        Assert.Empty(shipped.Complaints);
    }

    [Fact]
    public void Missing_table_of_signs_is_reported_and_the_rest_works()
    {
        using var driver = new ScriptDriver(faces: null);
        driver.Tick();

        Assert.StartsWith(
            "GtaDataHarvester: spaces_of_interest.csv cannot be read",
            Assert.Single(driver.Game.Notifications),
            StringComparison.Ordinal
        );
        driver.Press(Keys.NumPad0);
        driver.Tick(10);
        Assert.Single(driver.Game.Vehicles);
    }

    [Fact]
    public void Key_assigned_twice_is_reported_and_the_first_use_kept()
    {
        using var driver = new ScriptDriver("[Keys]\nMountCamera = NumPad0\n");
        driver.Tick();

        Assert.Contains("the key NumPad0 has two uses", Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);
        driver.Press(Keys.NumPad0);
        driver.Tick(10);
        Assert.Single(driver.Game.Vehicles);
    }

    [Fact]
    public void Script_can_be_created_by_the_loader_without_a_window()
    {
        using var driver = new ScriptDriver();
        var script = new HarvesterScript();
        script.RaiseTick();
        script.RaiseAborted();

        Assert.DoesNotContain(driver.Game.Notifications, message => message.Contains("failed", StringComparison.Ordinal));
    }
}
