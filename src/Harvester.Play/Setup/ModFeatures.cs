using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Play.Features;
using Harvester.Play.Plans;
using Harvester.Play.SelfTests;
using Harvester.Play.Settings;
using Harvester.Play.Surveys.Faces;
using Harvester.Play.Surveys.Paint;
using Harvester.Play.Surveys.Roads;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Setup;

/// <summary>
/// The features of the mod, made from its settings and a game. Making them does not call the game. What a key can start is a property.
/// </summary>
public sealed class ModFeatures
{
    private readonly ModSetup _setup;
    private readonly IGameAdapters _adapters;
    private readonly FeatureRules _rules;
    private readonly MeasuredFaces _faces;
    private readonly HarvestPorts _ports;
    private readonly PlayerCar _driven;

    /// <summary>Makes the features; all are off.</summary>
    /// <param name="setup">The settings, and what the features share.</param>
    /// <param name="adapters">The game.</param>
    public ModFeatures(ModSetup setup, IGameAdapters adapters)
    {
        _setup = setup ?? throw new ArgumentNullException(nameof(setup));
        _adapters = adapters ?? throw new ArgumentNullException(nameof(adapters));
        _rules = new FeatureRules(this);
        (ModFolder folder, PlayerSettings player, PlayerMessages messages) = (setup.Folder, setup.Player, setup.Messages);
        foreach (string warning in folder.Rig is { } rig ? GameRig.LensWarnings(rig) : [])
        {
            folder.Complain(warning);
        }

        _faces = new MeasuredFaces(player.FacesFolder, folder.ShippedFaces, folder.FacesWith(player.FacesFolder));
        adapters.Time.Method = player.Options.FreezeBy ?? FreezeMethod.Paused;
        Car = new TestCar(player, messages, adapters.Models, adapters.Vehicles, setup.Clock);
        Mount = new CameraMount(player, messages, adapters.Cameras, adapters.Vehicles);
        _ports = new HarvestPorts(setup, adapters, this, _rules);
        _driven = new PlayerCar(adapters.Controls, adapters.Vehicles, Mount, _ports.Scene.World);
        Drive = MakeDrive();
        Harvest = new Harvest(player.Options, player.Folder, messages, Mount, _ports.Game, Origin)
        {
            Problem = () => _rules.MeasurementObstacle() ?? folder.RigProblem,
            FacesInUse = () => _faces.InUse,
        };
        Calibration = new LensCalibration(Harvest, _ports.Game, Mount, messages, folder.SettingsPath) { Obstacle = _rules.PlanObstacle };
        SelfTest = new SelfTesting(Harvest, _ports.Game, Mount, messages, player.Folder, folder.SettingsPath, Origin)
        {
            Obstacle = _rules.PlanObstacle,
        };
        Overlay = new Overlay(Harvest, _ports.Game, messages, new OverlayReader(_ports.Scene.Sight), adapters.Display)
        {
            IsPictureNear = _rules.IsPictureNear,
        };
        Roads = MakeRoadSurvey();
        Signs = MakeSignSurvey();
        Marking = MakeMarking();
        Plan = MakePlan();
        Paint = MakePaintSurvey();
        UnknownModels = new UnknownModelsList(_ports.Scene.World, _ports.Scene.Props, () => _faces.InUse, player.FacesFolder, messages)
        {
            Problem = _rules.MeasurementObstacle,
        };
        Gaps = new TickGaps(messages, setup.Clock, _rules.IsRunning);
        All = new FeatureSet(
            messages,
            adapters.Calls,
            setup.RealTime,
            new GraphicsAdvice(() => GraphicsSettingsFile.Read(setup.GraphicsFile), messages),
            new FrozenWorld(adapters.Time, _rules.MayFreeze),
            _ports.Hidden,
            _ports.Sky,
            _ports.Hud,
            _ports.Sheets,
            _ports.Card,
            Car,
            _ports.Actors,
            Plan,
            Paint,
            Mount,
            Harvest,
            _ports.Lights,
            Calibration,
            SelfTest,
            _ports.Markers,
            Roads,
            Signs,
            Marking,
            UnknownModels,
            Drive,
            MakeLine(),
            Overlay
        );
    }

    /// <summary>All features, in the order of their ticks.</summary>
    public FeatureSet All { get; }

    /// <summary>Notices that the game gave no tick.</summary>
    public TickGaps Gaps { get; }

    /// <summary>Makes a car for the player.</summary>
    public TestCar Car { get; }

    /// <summary>The actors of scenarios.</summary>
    public StagedActors Actors => _ports.Actors;

    /// <summary>The camera on the player's vehicle.</summary>
    public CameraMount Mount { get; }

    /// <summary>Harvests a session or single frames.</summary>
    public Harvest Harvest { get; }

    /// <summary>Measures the lens.</summary>
    public LensCalibration Calibration { get; }

    /// <summary>Tests what harvests rely on.</summary>
    public SelfTesting SelfTest { get; }

    /// <summary>Draws what would be labelled.</summary>
    public Overlay Overlay { get; }

    /// <summary>Reads the road nodes.</summary>
    public RoadSurveying Roads { get; }

    /// <summary>Measures the faces of signs and lights.</summary>
    public FaceSurveying Signs { get; }

    /// <summary>Photographs roads from above.</summary>
    public PaintSurveying Paint { get; }

    /// <summary>Marks faces by hand.</summary>
    public FaceMarking Marking { get; }

    /// <summary>Lists models without faces.</summary>
    public UnknownModelsList UnknownModels { get; }

    /// <summary>Lets a client drive.</summary>
    public BridgeFeature Drive { get; }

    /// <summary>Runs the trials of a plan.</summary>
    public PlanFeature Plan { get; }

    private BridgeFeature MakeDrive() =>
        new(_setup.Player.Bridge, _ports.Game, _driven, Mount, _adapters.Display, _setup.Messages)
        {
            Obstacle = _rules.DriveObstacle,
            Recording = _setup.Player.Bridge.RecordSeconds is { } seconds ? MakeRecording(1 / seconds) : null,
        };

    private BridgeRecording MakeRecording(double rateHz) =>
        new(
            rateHz,
            _setup.Player.Options with
            {
                Image = _setup.Player.Bridge.Driving.Picture,
            },
            _setup.Player.Folder,
            _setup.Messages,
            _ports.Game,
            _driven,
            Origin,
            _setup.Player.Bridge.RecordLagTicks
        )
        {
            FacesInUse = () => _faces.InUse,
        };

    private RoadSurveying MakeRoadSurvey()
    {
        if (_setup.Player.RoadFile is { } file)
        {
            _ports.Roads.Prepare(
                () => RoadSurveyFile.Load(file) ?? throw new FileNotFoundException($"There is no {file}."),
                "roadFile",
                _setup.Player.PaintFile is { } paint ? network => MeasuredPaintFile.Load(paint, network) : null
            );
        }
        else if (_setup.Player.HasPaintWithoutRoads)
        {
            _setup.Folder.Complain("Paint under [Roads] is not used: it needs File, the road file on which it was measured.");
        }

        return new RoadSurveying(
            _adapters.Roads,
            () => _adapters.PlayerPosition,
            _setup.Player.SurveyFile,
            _ports.Roads,
            _setup.Messages,
            _setup.Clock
        )
        {
            GivesLanes = _setup.Player.RoadFile is null,
            AreLanesWanted = () => _setup.Player.RoadFile is null && (Overlay.IsOn || Drive.IsOn || Harvest.IsOn),
        };
    }

    private FaceSurveying MakeSignSurvey() =>
        new(
            _adapters.Stage,
            _setup.Player.TakesPhotographs
                ? new SurveyCamera(_adapters.Cameras, _setup.Screen, () => _ports.Game.World.ReadCamera().WindowAspect)
                : null,
            SurveyedModels.ToMeasure(_setup.Folder.ShippedFaces, _setup.Player.FurtherModels),
            _faces,
            Harvest,
            Mount,
            _setup.Messages,
            _setup.Clock,
            _setup.Player.SurveyBudgetMilliseconds
        );

    private PaintSurveying MakePaintSurvey() =>
        new(
            Harvest,
            Mount,
            _ports.Game,
            _driven,
            _setup.Player.RoadFile ?? _setup.Player.SurveyFile,
            Path.Combine(_setup.Player.Folder, "paint"),
            _setup.Messages
        )
        {
            Obstacle = _rules.PlanObstacle,
            Area = PaintArea,
            MetresPerPixel = _setup.Player.PaintMetresPerPixel,
        };

    private Func<SurveyArea?> PaintArea()
    {
        Vector3D player = _adapters.PlayerPosition;
        PlayerSettings settings = _setup.Player;
        return () =>
            settings.PaintRangeMetres is { } range
                ? new SurveyArea(
                    settings.PaintAround == SurveyPlace.Plan ? PlannedPlaces.In(settings.PlanFile) : [new Vector2D(player.X, player.Y)],
                    range
                )
                : null;
    }

    private FaceMarking MakeMarking() =>
        new(
            _ports.Game,
            _ports.Scene.Props,
            SignName.Choices(_setup.Player.SignNames, _setup.Folder.ShippedFaces),
            _setup.Folder.ShippedFaces,
            _faces,
            _adapters.Display,
            _setup.Messages
        )
        {
            IsPictureNear = _rules.IsPictureNear,
            IsHarvesting = () => Harvest.IsOn,
        };

    private PlanFeature MakePlan() =>
        new(
            _setup.Player.PlanFile,
            _setup.Player.PlansFolder,
            new TrialSurroundings
            {
                Game = _adapters.Trials,
                Grip = new TrialGrip(_adapters.Trials, _adapters.Controls),
                Controls = _adapters.Controls,
                Car = new TrialCar(_adapters.Vehicles, _adapters.Models, _adapters.Trials, ModelHash.Of(_setup.Player.CarModel)),
                Driven = _driven,
                World = _ports.Game.World,
                Roads = _adapters.Roads,
                Stage = new TrialStage(
                    _ports.Actors,
                    _ports.Roads.Near,
                    _setup.Player.LaneWidthMetres,
                    _setup.Player.NarrowLaneWidthMetres
                ),
                Settling = new PictureSettling(_setup.Screen, _setup.Clock),
                Harvest = new TrialHarvest(Harvest, Mount, _setup.Messages),
                Clock = _setup.Clock,
                Options = _setup.Player.Options,
                Log = _setup.Messages.Log,
            },
            _setup.Messages
        )
        {
            Obstacle = _rules.PlanObstacle,
            StartsByItself = _setup.Player.StartsPlan,
        };

    private HarvestLine MakeLine() =>
        new(Harvest, _setup.Player.Folder, _setup.Clock, _adapters.Display)
        {
            IsPictureNear = _rules.IsPictureNear,
            SurveyLines =
            [
                () => Harvest.Warning,
                () => SelfTest.Line,
                () => Plan.Line,
                () => Roads.Line,
                () => Paint.Line,
                () => Signs.Line,
                () => Marking.Line,
            ],
        };

    private SessionOrigin Origin() =>
        _setup.Origin with
        {
            RecordedUtc = DateTime.UtcNow.ToString("yyyy-MM-ddTHH:mm:ssZ", CultureInfo.InvariantCulture),
        };
}
