using System.Windows.Forms;
using GTA;
using GTA.UI;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Play.Features;
using Harvester.Play.Screen;
using Harvester.Play.Screen.Windows;
using Harvester.Play.Settings;
using Harvester.Play.Setup;
using Harvester.Play.Tapes;

namespace Harvester.Mod;

/// <summary>
/// The script that the game's loader starts. It binds the keys to the features and ticks them. <see cref="FeatureSet"/> stops a feature
/// that fails, with a message; the others continue.
/// </summary>
#pragma warning disable CA1001 // The loader ends a script by Aborted, which disposes the harvest.
public sealed class HarvesterScript : Script
#pragma warning restore CA1001
{
    private readonly ModFeatures _features;
    private readonly KeyBindings<Keys> _keys;
    private readonly Greeting _greeting;
    private readonly TapeRecorder? _tape;
    private readonly IBackgroundWatch? _work;
    private int _aborted;

    /// <summary>Reads the settings; the game is not used yet.</summary>
    public HarvesterScript()
        : this(GameWindowScreen.OfThisProcess(), new PlayerClock(), GameBuild.OfThisProcess(), null) { }

    /// <summary>Reads the settings; the game is not used yet.</summary>
    /// <param name="screen">Takes the pictures.</param>
    /// <param name="clock">Real time.</param>
    /// <param name="build">The game.</param>
    /// <param name="graphicsFile">The game's settings.xml; null for the player's.</param>
    /// <param name="api">Answers the calls to the game; null for the game itself.</param>
    /// <param name="work">Answers for the work on other threads; null for that work itself.</param>
    internal HarvesterScript(
        IScreen screen,
        IClock clock,
        GameBuild build,
        string? graphicsFile,
        IGameApi? api = null,
        IBackgroundWatch? work = null
    )
    {
        var window = screen as IGameWindow;
        IClock realTime = clock;
        string tool = $"GtaDataHarvester {typeof(HarvesterScript).Assembly.GetName().Version}";
        var folder = new ModFolder(BaseDirectory);
        var messages = new PlayerMessages(BaseDirectory, message => Notification.Show(GameText.Plain(message)), clock);
        PlayerSettings player = PlayerSettings.Read(folder.Settings, BaseDirectory);
        player = player with { Options = GameRig.AppliedTo(player.Options with { Materials = folder.Materials }, folder.Rig) };
        _tape = api is null ? ScriptTape.Start(folder, player, BaseDirectory, build, clock, messages) : null;
        Natives.Game = api ?? (_tape is null ? new ScriptApi() : new TapedApi(new ScriptApi(), _tape));
        _work = work ?? (_tape is null ? null : new TapedBackground(_tape));
        if (_tape is not null)
        {
            (screen, clock) = (new TapedScreen(screen, _tape), new TapedClock(clock, _tape));
        }

        _features = new ModFeatures(
            new ModSetup
            {
                Folder = folder,
                Player = player,
                Messages = messages,
                Screen = screen,
                Clock = clock,
                RealTime = realTime,
                GraphicsFile = graphicsFile ?? GraphicsSettingsFile.PathOf(build.IsEnhanced),
                Origin = new SessionOrigin
                {
                    Game = build.Name,
                    Tool = tool,
                    Truth = LabelTruths.OfGame,
                    Settings = [.. build.Settings, .. player.LaneSettings],
                },
            },
            new ScriptGame(build, messages)
        );
        _greeting = new Greeting($"{tool}, API {build.Api}, {build.Name}", folder, window, _tape, messages);
        _keys = new KeyBindings<Keys>(folder, _features.All);
        BindKeys(_features);
        Tick += OnTick;
        KeyDown += OnKeyDown;
        KeyUp += OnKeyUp;
        Aborted += OnAborted;
    }

    /// <summary>The actors of scenarios.</summary>
    internal StagedActors Actors => _features.Actors;

    /// <summary>Whether work continues on another thread.</summary>
    internal bool IsBusy => _features.All.IsBusy || _tape is { IsBusy: true };

    private void BindKeys(ModFeatures features)
    {
        _keys.Add("SpawnTestCar", Keys.NumPad0, features.Car, features.Car.Spawn);
        _keys.Add("MountCamera", Keys.I, features.Mount, features.Mount.Mount);
        _keys.Add("RestoreCamera", Keys.O, features.Mount, features.Mount.Stop);
        _keys.Add("Harvest", Keys.J, features.Harvest, features.Harvest.Toggle);
        _keys.Add("OneFrame", Keys.K, features.Harvest, features.Harvest.TakeOne);
        _keys.Add("Overlay", Keys.L, features.Overlay, features.Overlay.Toggle);
        _keys.Add("SelfTest", Keys.T, features.SelfTest, features.SelfTest.Toggle);
        _keys.Add("Calibrate", Keys.NumPad1, features.Calibration, features.Calibration.Toggle);
        _keys.Add("RoadSurvey", Keys.U, features.Roads, features.Roads.Toggle);
        _keys.Add("PaintSurvey", Keys.End, features.Paint, features.Paint.Toggle);
        _keys.Add("Drive", Keys.N, features.Drive, features.Drive.Toggle);
        _keys.Add("Plan", Keys.Decimal, features.Plan, features.Plan.Toggle);
        _keys.Add("SpaceSurvey", Keys.Multiply, features.Signs, features.Signs.Toggle);
        _keys.Add("MarkCorner", Keys.NumPad2, features.Marking, features.Marking.Mark);
        _keys.Add("NextName", Keys.NumPad3, features.Marking, features.Marking.NextName);
        _keys.Add("KeepFace", Keys.Y, features.Marking, features.Marking.Keep);
        _keys.Add("UnknownModels", Keys.Divide, features.UnknownModels, features.UnknownModels.Look);
        _keys.AddGoingDown("Bridge", "TakeBackKeys", [Keys.W, Keys.A, Keys.S, Keys.D, Keys.Space], features.Drive, features.Drive.TakeBack);
    }

    private void OnTick(object? sender, EventArgs e)
    {
        if (!BeginEvent(null))
        {
            return;
        }

        try
        {
            _greeting.Tick(_features.All);
            _features.Gaps.Begin();
            _features.All.Tick();
            _features.Gaps.End();
        }
        finally
        {
            EndEvent();
        }
    }

    // Key up instead of key down: Windows repeats the latter as long as a key is held.
    private void OnKeyUp(object? sender, KeyEventArgs e)
    {
        if (_keys.HasPress(e.KeyCode))
        {
            Handle(new TapeKey((int)e.KeyCode, false), _keys.Press, e.KeyCode);
        }
    }

    // The player's input must be noticed whatever the game does with its controls.
    private void OnKeyDown(object? sender, KeyEventArgs e)
    {
        if (_keys.HasGoingDown(e.KeyCode))
        {
            Handle(new TapeKey((int)e.KeyCode, true), _keys.GoDown, e.KeyCode);
        }
    }

    private void Handle(TapeKey key, Action<Keys> handle, Keys code)
    {
        if (!BeginEvent(key))
        {
            return;
        }

        try
        {
            handle(code);
        }
        finally
        {
            EndEvent();
        }
    }

    /// <returns>Whether the event is handled; after the script's end none is.</returns>
    private bool BeginEvent(TapeKey? key)
    {
        if (_aborted != 0)
        {
            return false;
        }

        Background.Watch = _work;
        _tape?.BeginEvent(key);
        return true;
    }

    private void EndEvent()
    {
        _tape?.EndEvent();
        Background.Watch = null;
    }

    // The loader may raise this twice, and on another thread while the script's own is stopped in the middle of a tick. So this takes no
    // lock, which that thread might hold forever, but sets a flag that only one caller finds unset.
    private void OnAborted(object? sender, EventArgs e)
    {
        if (Interlocked.Exchange(ref _aborted, 1) == 0)
        {
            _tape?.Finish();
            _features.All.Finish();
            _tape?.Dispose();
        }
    }
}
