using System;
using System.Collections.Generic;
using System.Threading;
using System.Windows.Forms;
using GTA;

namespace Harvester.Mod;

/// <summary>
/// The script that the game's loader starts: it binds the keys to the features and lets no exception of theirs out. A feature that
/// fails is stopped with a message; the others go on.
/// </summary>
public sealed class HarvesterScript : Script
{
    private readonly Messages _messages;
    private readonly ModSettings _settings;
    private readonly Dictionary<Keys, (IFeature Feature, Action Press)> _keys = [];
    private readonly TestCar _car;
    private readonly IFeature[] _features;
    private bool _greeted;
    private int _aborted;

    /// <summary>Reads the settings; the game is not asked for anything yet.</summary>
    public HarvesterScript()
    {
        _messages = new Messages(BaseDirectory);
        _settings = ModSettings.Load(GetRelativePath("GtaDataHarvester.ini"), _messages);
        _car = new TestCar(_settings, _messages);
        var mount = new CameraMount(_settings, _messages);
        _features = [_car, mount];
        Bind(_settings.SpawnKey, _car, _car.Spawn);
        Bind(_settings.MountKey, mount, mount.Mount);
        Bind(_settings.RestoreKey, mount, mount.Stop);
        Tick += OnTick;
        KeyUp += OnKeyUp;
        Aborted += OnAborted;
    }

    private string GetRelativePath(string file) => System.IO.Path.Combine(BaseDirectory, file);

    private void Bind(Keys key, IFeature feature, Action press)
    {
        if (_keys.ContainsKey(key))
        {
            _messages.Log($"The key {key} has two uses in GtaDataHarvester.ini; the first is kept.");
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
        if (Interlocked.Exchange(ref _aborted, 1) != 0)
        {
            return;
        }

        foreach (IFeature feature in _features)
        {
            Try(feature, feature.Stop);
        }

        Try(_car, _car.Remove);
    }

    private void Greet()
    {
        if (_greeted)
        {
            return;
        }

        _greeted = true;
        Try(_car, () => _messages.Log(
            $"GtaDataHarvester {typeof(HarvesterScript).Assembly.GetName().Version}, API {typeof(Script).Assembly.GetName().Version}, game build {Game.Version}."));
        foreach (string complaint in _settings.Complaints)
        {
            _messages.Tell("GtaDataHarvester.ini: " + complaint);
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
