using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Windows.Forms;
using GTA;
using Harvester.Capture.Ports;
using Harvester.Capture.Screen;
using Harvester.Capture.Spaces;

namespace Harvester.Mod;

/// <summary>
/// The script that the game's loader starts: it binds the keys to the features and lets no exception of theirs out. A feature that
/// fails is stopped with a message; the others go on.
/// </summary>
#pragma warning disable CA1001 // The loader ends a script by Aborted, which disposes the harvest.
public sealed class HarvesterScript : Script
#pragma warning restore CA1001
{
    private readonly Messages _messages;
    private readonly List<string> _complaints = [];
    private readonly Dictionary<Keys, (IFeature Feature, Action Press)> _keys = [];
    private readonly TestCar _car;
    private readonly CameraMount _mount;
    private readonly Harvest _harvest;
    private readonly IFeature[] _features;
    private bool _greeted;
    private int _aborted;

    /// <summary>Reads the settings; the game is not asked for anything yet.</summary>
    public HarvesterScript()
        : this(GameWindowScreen.OfThisProcess(), new PlayerClock())
    {
    }

    internal HarvesterScript(IScreen screen, IClock clock)
    {
        string folder = BaseDirectory;
        _messages = new Messages(folder);
        ModSettings settings = Read(() => ModSettings.Load(folder), () => ModSettings.Default(folder), ModSettings.FileName);
        _complaints.AddRange(settings.Complaints);
        SpaceTable spaces = ReadSpaces(folder);
        _car = new TestCar(settings, _messages, clock);
        _mount = new CameraMount(settings, _messages);
        var pause = new GamePause();
        var rays = new GameRays();
        var world = new GameWorld(_mount, pause, rays, spaces);
        _harvest = new Harvest(settings, _messages, _mount, new GamePorts(world, rays, screen, pause, clock));
        var overlay = new Overlay(settings, _messages, world, spaces, _harvest);
        _features = [_car, _mount, _harvest, new Hud(_harvest, settings.Folder, clock), overlay];
        Bind(settings.SpawnKey, _car, _car.Spawn);
        Bind(settings.MountKey, _mount, _mount.Mount);
        Bind(settings.RestoreKey, _mount, _mount.Stop);
        Bind(settings.HarvestKey, _harvest, _harvest.Toggle);
        Bind(settings.FrameKey, _harvest, _harvest.TakeOne);
        Bind(settings.OverlayKey, overlay, overlay.Toggle);
        Tick += OnTick;
        KeyUp += OnKeyUp;
        Aborted += OnAborted;
    }

    /// <summary>Whether an ended harvest is still being written.</summary>
    internal bool IsWriting => _harvest.IsWriting;

    private SpaceTable ReadSpaces(string folder)
    {
        const string file = "spaces_of_interest.csv";
        SpaceTableContent content = Read(Load, () => new SpaceTableContent(SpaceTable.Empty, []), file);
        foreach (SpaceTableProblem problem in content.Problems)
        {
            _complaints.Add($"{file}: {problem}");
        }

        return content.Table;

        SpaceTableContent Load()
        {
            using var reader = new StreamReader(Path.Combine(folder, file));
            return SpaceTableReader.Read(reader);
        }
    }

    private T Read<T>(Func<T> read, Func<T> fallback, string file)
    {
        try
        {
            return read();
        }
        catch (Exception exception) when (exception is not ThreadAbortException)
        {
            _complaints.Add($"{file} cannot be read: {exception.Message}");
            return fallback();
        }
    }

    private void Bind(Keys key, IFeature feature, Action press)
    {
        if (_keys.ContainsKey(key))
        {
            _complaints.Add($"{ModSettings.FileName}: the key {key} has two uses; the first is kept.");
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
        foreach (IFeature feature in _features)
        {
            Guard(feature, feature.Tick);
        }
    }

    // Key up and not key down: Windows repeats the latter as long as a key is held.
    private void OnKeyUp(object? sender, KeyEventArgs e)
    {
        if (_aborted == 0 && _keys.TryGetValue(e.KeyCode, out (IFeature Feature, Action Press) key))
        {
            Guard(key.Feature, key.Press);
        }
    }

    // The loader may raise this twice, and on another thread while the script's own is stopped in the middle of a tick: so no lock,
    // which that thread might hold for ever, but a flag that only one caller finds unset.
    private void OnAborted(object? sender, EventArgs e)
    {
        if (Interlocked.Exchange(ref _aborted, 1) == 0)
        {
            Try(_harvest, _harvest.Dispose);
            Try(_mount, _mount.Stop);
            Try(_car, _car.Remove);
        }
    }

    private void Greet()
    {
        if (_greeted)
        {
            return;
        }

        _greeted = true;
        Try(_mount, () => _messages.Log(
            $"GtaDataHarvester {typeof(HarvesterScript).Assembly.GetName().Version}, API {typeof(Script).Assembly.GetName().Version}, game build {Game.Version}."));
        foreach (string complaint in _complaints)
        {
            _messages.Tell(complaint);
        }
    }

    private void Guard(IFeature feature, Action work)
    {
        if (!Try(feature, work))
        {
            Try(feature, feature.Stop);
        }
    }

    private bool Try(IFeature feature, Action work)
    {
        try
        {
            work();
            return true;
        }
        catch (Exception exception) when (exception is not ThreadAbortException)
        {
            _messages.TellFailure(feature.Name, exception);
            return false;
        }
    }
}
