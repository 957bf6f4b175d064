using System.Globalization;
using System.Windows.Forms;
using GTA;
using GTA.Native;
using GTA.UI;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Play.Features;
using Harvester.Play.Plans;
using Harvester.Play.Screen;
using Harvester.Play.Screen.Windows;
using Harvester.Play.SelfTests;
using Harvester.Play.Settings;
using Harvester.Play.Surveys.Faces;
using Harvester.Play.Surveys.Roads;
using Harvester.Play.Tapes;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod;

/// <summary>
/// The script that the game's loader starts. It binds the keys to the features and catches all their exceptions. A feature that fails is
/// stopped with a message; the others continue.
/// </summary>
#pragma warning disable CA1001 // The loader ends a script by Aborted, which disposes the harvest.
public sealed class HarvesterScript : Script
#pragma warning restore CA1001
{
    private readonly GameBuild _build;
    private readonly PlayerMessages _messages;
    private readonly IGameWindow? _window;
    private readonly ModFolder _folder;
    private readonly Harvest _harvest;
    private readonly LensCalibration _calibration;
    private readonly BridgeFeature _drive;
    private readonly FaceSurveying _signs;
    private readonly PlanFeature _plan;
    private readonly SelfTesting _selfTest;
    private readonly FeatureSet _features;
    private readonly KeyBindings<Keys> _keys;
    private readonly TickGaps _gaps;
    private readonly TapeRecorder? _tape;
    private readonly IBackgroundWatch? _work;
    private bool _greeted;
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
        IClock realTime = clock;
        _build = build;
        _window = screen as IGameWindow;
        _folder = new ModFolder(BaseDirectory);
        _messages = new PlayerMessages(BaseDirectory, message => Notification.Show(GameText.Plain(message)), clock);
        PlayerSettings player = PlayerSettings.Read(_folder.Settings, BaseDirectory);
        player = player with { Options = GameRig.AppliedTo(player.Options with { Materials = _folder.Materials }, _folder.Rig) };
        _tape = api is null ? ScriptTape.Start(_folder, player, BaseDirectory, build, clock, _messages) : null;
        Natives.Game = api ?? (_tape is null ? new ScriptApi() : new TapedApi(new ScriptApi(), _tape));
        _work = work ?? (_tape is null ? null : new TapedBackground(_tape));
        if (_tape is not null)
        {
            (screen, clock) = (new TapedScreen(screen, _tape), new TapedClock(clock, _tape));
        }

        if (_folder.Rig is { } rig)
        {
            foreach (string warning in GameRig.LensWarnings(rig))
            {
                _folder.Complain(warning);
            }
        }
        var measured = new MeasuredFaces(player.FacesFolder, _folder.ShippedFaces, _folder.FacesWith(player.FacesFolder));
        var display = new GameDisplay();
        var time = new GameTime(GameFreeze.Set, () => Natives.Call<int>(Hash.GET_GAME_TIMER))
        {
            Method = player.Options.FreezeBy ?? FreezeMethod.Paused,
        };
        var rays = new GameRays();
        var reading = new ReadingRecord();
        var calls = new GameCalls(rays);
        var markers = new DrawnMarkers(display);
        var sheets = new DrawnSheets(display);
        var hud = new HiddenHud(new GameHud(), display, TakesPictures);
        var card = new DrawnCard(display);
        var roads = new GrowingRoads(player.LaneWidthMetres, player.NarrowLaneWidthMetres);
        var vehicles = new GameVehicles();
        var models = new GameModels();
        var cameras = new GameCameras(build);
        var car = new TestCar(player, _messages, models, vehicles, clock);
        var mount = new CameraMount(player, _messages, cameras, vehicles);
        var nearby = new NearbyEntities(build, new NativeLists(time, rays), reading, _messages);
        var hidden = new HiddenEntities(
            new GameShownEntities(nearby),
            _folder.HiddenPath,
            _messages,
            () => _harvest!.IsOn || _selfTest!.IsOn
        );
        var world = new GameWorld(mount, time, rays, models, () => _harvest!.Faces, nearby, reading)
        {
            LooksAround = () => _harvest!.HasRig,
        };
        var lights = new LightControl(
            world,
            new GameTrafficLights(),
            player.LightOrder,
            player.Options.RangeMetres,
            player.Options.MaxPictureLagTicks + 2
        )
        {
            IsWanted = () => player.DrivesLights && _harvest!.IsOn,
        };
        var controls = new GameCarControls();
        var game = new GamePorts(world, rays, screen, time, clock, markers)
        {
            Roads = roads,
            Lights = lights,
            MountedCamera = mount,
            RigCamera = mount,
            SurfaceRays = rays,
            Visibility = hidden,
            Sky = new PlayerSky(controls, world) { Kept = () => _plan?.Weather },
            Sheets = sheets,
            Hud = hud,
            Card = card,
            Calls = calls,
            Reading = reading,
        };
        var driven = new PlayerCar(controls, vehicles, mount, world);
        _drive = new BridgeFeature(player.Bridge, game, driven, mount, display, _messages)
        {
            Obstacle = DriveObstacle,
            Recording = player.Bridge.RecordSeconds is { } seconds
                ? new BridgeRecording(
                    1 / seconds,
                    player.Options with
                    {
                        Image = player.Bridge.Driving.Picture,
                    },
                    player.Folder,
                    _messages,
                    game,
                    driven,
                    () => Origin(player),
                    player.Bridge.RecordLagTicks
                )
                {
                    FacesInUse = () => measured.InUse,
                }
                : null,
        };
        _harvest = new Harvest(player.Options, player.Folder, _messages, mount, game, () => Origin(player))
        {
            Problem = HarvestProblem,
            FacesInUse = () => measured.InUse,
        };
        _calibration = new LensCalibration(_harvest, game, mount, _messages, _folder.SettingsPath);
        _selfTest = new SelfTesting(_harvest, game, mount, _messages, player.Folder, _folder.SettingsPath, () => Origin(player))
        {
            Obstacle = DriveObstacle,
        };
        var overlay = new Overlay(_harvest, game, _messages, new OverlayReader(new GameSight(mount, world)), display)
        {
            IsPictureNear = IsPictureNear,
        };
        var survey = new RoadSurveying(
            new GameRoadSource(),
            () => Natives.EntityPosition(Natives.PlayerPed()),
            player.SurveyFile,
            roads,
            _messages,
            clock
        )
        {
            GivesLanes = player.RoadFile is null,
            AreLanesWanted = () => player.RoadFile is null && (overlay.IsOn || _drive.IsOn || _harvest.IsOn),
        };
        _signs = new FaceSurveying(
            new GameStage(models, rays),
            player.TakesPhotographs ? new SurveyCamera(cameras, screen, () => world.ReadCamera().WindowAspect) : null,
            SurveyedModels.ToMeasure(_folder.ShippedFaces, player.FurtherModels),
            measured,
            _harvest,
            mount,
            _messages,
            clock,
            player.SurveyBudgetMilliseconds
        );
        var marking = new FaceMarking(
            game,
            world,
            SignName.Choices(player.SignNames, _folder.ShippedFaces),
            _folder.ShippedFaces,
            measured,
            display,
            _messages
        )
        {
            IsPictureNear = IsPictureNear,
            IsHarvesting = () => _harvest.IsOn,
        };
        _plan = Plan(player, game, driven, mount, models, vehicles, clock);
        var unknown = new UnknownModelsList(world, world, () => measured.InUse, player.FacesFolder, _messages) { Problem = Problem };
        var line = new HarvestLine(_harvest, player.Folder, clock, display)
        {
            IsPictureNear = IsPictureNear,
            SurveyLines =
            [
                () => _harvest.Warning,
                () => _selfTest.Line,
                () => _plan.Line,
                () => survey.Line,
                () => _signs.Line,
                () => marking.Line,
            ],
        };
        var frozen = new FrozenWorld(time, () => _harvest.IsOn || _calibration.IsOn || _drive.IsOn || _selfTest.IsOn);
        string graphics = graphicsFile ?? GraphicsSettingsFile.PathOf(build.IsEnhanced);
        var advice = new GraphicsAdvice(() => GraphicsSettingsFile.Read(graphics), _messages);
        _features = new FeatureSet(
            _messages,
            calls,
            realTime,
            advice,
            frozen,
            hidden,
            hud,
            sheets,
            card,
            car,
            _plan,
            mount,
            _harvest,
            lights,
            _calibration,
            _selfTest,
            markers,
            survey,
            _signs,
            marking,
            unknown,
            _drive,
            line,
            overlay
        );
        if (player.RoadFile is { } file)
        {
            roads.Prepare(() => RoadSurveyFile.Load(file) ?? throw new FileNotFoundException($"There is no {file}."), "roadFile");
        }

        _gaps = new TickGaps(_messages, clock, () => _harvest.IsOn || _drive.IsOn || _plan.IsOn || _selfTest.IsOn);
        _keys = new KeyBindings<Keys>(_folder, _features);
        BindKeys(car, mount, overlay, survey, marking, unknown);
        Tick += OnTick;
        KeyDown += OnKeyDown;
        KeyUp += OnKeyUp;
        Aborted += OnAborted;
    }

    /// <summary>Whether work continues on another thread.</summary>
    internal bool IsBusy => _features.IsBusy || _tape is { IsBusy: true };

    private void BindKeys(
        TestCar car,
        CameraMount mount,
        Overlay overlay,
        RoadSurveying survey,
        FaceMarking marking,
        UnknownModelsList unknown
    )
    {
        _keys.Add("SpawnTestCar", Keys.NumPad0, car, car.Spawn);
        _keys.Add("MountCamera", Keys.I, mount, mount.Mount);
        _keys.Add("RestoreCamera", Keys.O, mount, mount.Stop);
        _keys.Add("Harvest", Keys.J, _harvest, _harvest.Toggle);
        _keys.Add("OneFrame", Keys.K, _harvest, _harvest.TakeOne);
        _keys.Add("Overlay", Keys.L, overlay, overlay.Toggle);
        _keys.Add("SelfTest", Keys.T, _selfTest, _selfTest.Toggle);
        _keys.Add("Calibrate", Keys.NumPad1, _calibration, _calibration.Toggle);
        _keys.Add("RoadSurvey", Keys.U, survey, survey.Toggle);
        _keys.Add("Drive", Keys.N, _drive, _drive.Toggle);
        _keys.Add("Plan", Keys.Decimal, _plan, _plan.Toggle);
        _keys.Add("SpaceSurvey", Keys.Multiply, _signs, _signs.Toggle);
        _keys.Add("MarkCorner", Keys.NumPad2, marking, marking.Mark);
        _keys.Add("NextName", Keys.NumPad3, marking, marking.NextName);
        _keys.Add("KeepFace", Keys.Y, marking, marking.Keep);
        _keys.Add("UnknownModels", Keys.Divide, unknown, unknown.Look);
        _keys.AddGoingDown("Bridge", "TakeBackKeys", [Keys.W, Keys.A, Keys.S, Keys.D, Keys.Space], _drive, _drive.TakeBack);
    }

    private void OnTick(object? sender, EventArgs e)
    {
        Handle(
            null,
            () =>
            {
                Greet();
                _gaps.Begin();
                _features.Tick();
                _gaps.End();
            }
        );
    }

    // Key up instead of key down: Windows repeats the latter as long as a key is held.
    private void OnKeyUp(object? sender, KeyEventArgs e)
    {
        if (_keys.HasPress(e.KeyCode))
        {
            Handle(new TapeKey((int)e.KeyCode, false), () => _keys.Press(e.KeyCode));
        }
    }

    // The player's input must be noticed whatever the game does with its controls.
    private void OnKeyDown(object? sender, KeyEventArgs e)
    {
        if (_keys.HasGoingDown(e.KeyCode))
        {
            Handle(new TapeKey((int)e.KeyCode, true), () => _keys.GoDown(e.KeyCode));
        }
    }

    private void Handle(TapeKey? key, Action handle)
    {
        if (_aborted != 0)
        {
            return;
        }

        Background.Watch = _work;
        _tape?.BeginEvent(key);
        try
        {
            handle();
        }
        finally
        {
            _tape?.EndEvent();
            Background.Watch = null;
        }
    }

    // The loader may raise this twice, and on another thread while the script's own is stopped in the middle of a tick. So this takes no
    // lock, which that thread might hold forever, but sets a flag that only one caller finds unset.
    private void OnAborted(object? sender, EventArgs e)
    {
        if (Interlocked.Exchange(ref _aborted, 1) == 0)
        {
            _tape?.Finish();
            _features.Finish();
            _tape?.Dispose();
        }
    }

    private void Greet()
    {
        if (_greeted)
        {
            return;
        }

        _greeted = true;
        _features.Try("The mod", LogHeaderLines);
        foreach (string complaint in _folder.RigProblem is { } problem ? _folder.Complaints.Append(problem) : _folder.Complaints)
        {
            _messages.Tell(complaint);
        }

        if (_tape is { IsOn: true })
        {
            _messages.Tell(_tape.Greeting);
        }
    }

    private void LogHeaderLines()
    {
        string versions = $"GtaDataHarvester {typeof(HarvesterScript).Assembly.GetName().Version}, API {_build.Api}, {_build.Name}";
        foreach (string line in LogHeader.Lines(versions, _window, _folder.Settings.Changes))
        {
            _messages.Log(line);
            if (line.StartsWith(LogHeader.Window, StringComparison.Ordinal) && line.Contains(WindowDescription.Hdr))
            {
                _messages.Tell("HDR is on in Windows: pictures may be overexposed. Switch it off, or check the colours by the self-test.");
            }
        }
    }

    private bool IsPictureNear() =>
        _harvest.IsPictureNear || _calibration.IsOn || _drive.IsPictureNear || _signs.IsPictureNear || _selfTest.IsPictureNear;

    private bool TakesPictures() => _harvest.IsOn || _calibration.IsOn || _signs.IsPictureNear || _drive.IsOn;

    private string? Problem() =>
        _selfTest.IsOn ? "The self-test is running: wait for its end, or end it by its key."
        : _calibration.IsOn ? "The calibration is running: wait for its end."
        : _signs.IsOn ? "The survey of signs is running: wait for its end, or end it by its key."
        : null;

    private string? HarvestProblem() => Problem() ?? _folder.RigProblem;

    private string? DriveObstacle() =>
        _plan.IsOn ? "A plan is running: end it by its key first."
        : _harvest.IsOn ? "End the harvest first, then let a client drive."
        : Problem();

    private PlanFeature Plan(
        PlayerSettings player,
        GamePorts game,
        PlayerCar driven,
        CameraMount mount,
        GameModels models,
        GameVehicles vehicles,
        IClock clock
    )
    {
        var trials = new GameTrials();
        var controls = new GameCarControls();
        return new PlanFeature(
            player.PlanFile,
            player.PlansFolder,
            new TrialSurroundings
            {
                Game = trials,
                Grip = new TrialGrip(trials, controls),
                Controls = controls,
                Car = new TrialCar(vehicles, models, trials, ModelHash.Of(player.CarModel)),
                Driven = driven,
                World = game.World,
                Roads = new GameRoadSource(),
                Settling = new PictureSettling(game.Screen, clock),
                Harvest = new TrialHarvest(_harvest, mount, _messages),
                Clock = clock,
                Options = player.Options,
                Log = _messages.Log,
            },
            _messages
        )
        {
            Obstacle = () => _drive.IsOn ? "A client drives: end that first." : DriveObstacle(),
            StartsByItself = player.StartsPlan,
        };
    }

    private SessionOrigin Origin(PlayerSettings player) =>
        new()
        {
            Game = _build.Name,
            Tool = $"GtaDataHarvester {typeof(HarvesterScript).Assembly.GetName().Version}",
            RecordedUtc = DateTime.UtcNow.ToString("yyyy-MM-ddTHH:mm:ssZ", CultureInfo.InvariantCulture),
            Truth = LabelTruths.OfGame,
            Settings = [.. _build.Settings, .. player.LaneSettings],
        };
}
