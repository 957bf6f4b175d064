using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Threading;
using System.Windows.Forms;
using GTA;
using GTA.UI;
using Harvester.Capture.Playing;
using Harvester.Capture.Ports;
using Harvester.Capture.Roads;
using Harvester.Capture.Screen;
using Harvester.Capture.Settings;
using Harvester.Capture.Storage;

namespace Harvester.Mod;

/// <summary>
/// The script that the game's loader starts: it binds the keys to the features and lets no exception of theirs out. A feature that
/// fails is stopped with a message; the others go on.
/// </summary>
#pragma warning disable CA1001 // The loader ends a script by Aborted, which disposes the harvest.
public sealed class HarvesterScript : Script
#pragma warning restore CA1001
{
    private readonly PlayerMessages _messages;
    private readonly ModFolder _folder;
    private readonly Dictionary<Keys, (IFeature Feature, Action Press)> _keys = [];
    private readonly TestCar _car;
    private readonly CameraMount _mount;
    private readonly Harvest _harvest;
    private readonly LensCalibration _calibration;
    private readonly RoadSurveying _survey;
    private readonly FeatureSet _features;
    private bool _greeted;
    private int _aborted;

    /// <summary>Reads the settings; the game is not asked for anything yet.</summary>
    public HarvesterScript()
        : this(GameWindowScreen.OfThisProcess(), new PlayerClock())
    {
    }

    internal HarvesterScript(IScreen screen, IClock clock)
    {
        _folder = new ModFolder(BaseDirectory);
        _messages = new PlayerMessages(BaseDirectory, message => Notification.Show(message));
        PlayerSettings player = PlayerSettings.Read(_folder.Settings, BaseDirectory);
        var display = new GameDisplay();
        var pause = new GamePause();
        var rays = new GameRays();
        var markers = new GameMarkers();
        var roads = new GrowingRoads(player.LaneWidthMetres);
        _car = new TestCar(player, _messages, clock);
        _mount = new CameraMount(player, _messages);
        var game = new GamePorts(new GameWorld(_mount, pause, rays, _folder.Spaces), rays, screen, pause, clock, markers) { Roads = roads };
        _harvest = new Harvest(player.Options, player.Folder, _messages, _mount, game, display, Origin) { Problem = Problem };
        _calibration = new LensCalibration(_harvest, game, _mount, display, _messages, _folder.SettingsPath);
        var overlay = new Overlay(_harvest, game, _folder.Spaces, _messages, _mount, display) { IsPictureNear = IsPictureNear };
        _survey = new RoadSurveying(
            new GameRoadSource(), () => Natives.EntityPosition(Natives.PlayerPed()), player.SurveyFile, roads, _messages, clock)
        {
            GivesLanes = player.RoadFile is null,
            AreLanesWanted = () => player.RoadFile is null && (overlay.IsOn || _harvest.Status is not null),
        };
        var line = new HarvestLine(_harvest, player.Folder, clock, display) { IsPictureNear = IsPictureNear, SurveyLine = () => _survey.Line };
        _features = new FeatureSet(_messages, _car, _mount, _harvest, _calibration, markers, _survey, line, overlay);
        if (player.RoadFile is { } file)
        {
            roads.Prepare(() => RoadSurveyFile.Load(file) ?? throw new FileNotFoundException($"There is no {file}."), "roadFile");
        }

        Bind("SpawnTestCar", Keys.NumPad0, _car, _car.Spawn);
        Bind("MountCamera", Keys.I, _mount, _mount.Mount);
        Bind("RestoreCamera", Keys.O, _mount, _mount.Stop);
        Bind("Harvest", Keys.J, _harvest, _harvest.Toggle);
        Bind("OneFrame", Keys.K, _harvest, _harvest.TakeOne);
        Bind("Overlay", Keys.L, overlay, overlay.Toggle);
        Bind("Calibrate", Keys.C, _calibration, _calibration.Toggle);
        Bind("RoadSurvey", Keys.U, _survey, _survey.Toggle);
        Tick += OnTick;
        KeyUp += OnKeyUp;
        Aborted += OnAborted;
    }

    /// <summary>Whether a file is still being written.</summary>
    internal bool IsWriting => _harvest.IsWriting || _calibration.IsWriting || _survey.IsWriting;

    private void Bind(string name, Keys fallback, IFeature feature, Action press)
    {
        Keys key = _folder.Settings.Choice("Keys", name, fallback, "a key, such as NumPad0, I or F9");
        if (_keys.ContainsKey(key))
        {
            _folder.Complain($"the key {key} has two uses; the first is kept.");
            return;
        }

        _keys.Add(key, (feature, press));
    }

    private void OnTick(object? sender, EventArgs e)
    {
        if (_aborted != 0)
        {
            return;
        }

        Greet();
        _features.Tick();
    }

    // Key up and not key down: Windows repeats the latter as long as a key is held.
    private void OnKeyUp(object? sender, KeyEventArgs e)
    {
        if (_aborted == 0 && _keys.TryGetValue(e.KeyCode, out (IFeature Feature, Action Press) key))
        {
            _features.Do(key.Feature, key.Press);
        }
    }

    // The loader may raise this twice, and on another thread while the script's own is stopped in the middle of a tick: so no lock,
    // which that thread might hold for ever, but a flag that only one caller finds unset.
    private void OnAborted(object? sender, EventArgs e)
    {
        if (Interlocked.Exchange(ref _aborted, 1) == 0)
        {
            _features.Try(_calibration.Name, _calibration.Stop);
            _features.Try(_harvest.Name, _harvest.Dispose);
            _features.Try(_survey.Name, _survey.Finish);
            _features.Try(_mount.Name, _mount.Stop);
            _features.Try(_car.Name, _car.Remove);
        }
    }

    private void Greet()
    {
        if (_greeted)
        {
            return;
        }

        _greeted = true;
        _features.Try("The mod", () => _messages.Log(
            $"GtaDataHarvester {typeof(HarvesterScript).Assembly.GetName().Version}, API {typeof(Script).Assembly.GetName().Version}, game build {Game.Version}."));
        foreach (string complaint in _folder.Complaints)
        {
            _messages.Tell(complaint);
        }
    }

    private bool IsPictureNear() => _harvest.IsPictureNear || _calibration.IsRunning;

    private string? Problem() => _calibration.IsRunning ? "The calibration is running: wait for its end." : GameBuild.ListProblem;

    private static SessionOrigin Origin() => new()
    {
        Game = $"GTA V {Game.Version}",
        Tool = $"GtaDataHarvester {typeof(HarvesterScript).Assembly.GetName().Version}",
        RecordedUtc = DateTime.UtcNow.ToString("yyyy-MM-ddTHH:mm:ssZ", CultureInfo.InvariantCulture),
    };
}
