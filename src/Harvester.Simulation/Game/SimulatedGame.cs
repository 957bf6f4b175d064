using System.Diagnostics.CodeAnalysis;
using System.Numerics;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Paint;
using Harvester.Geometry.PixelMaps.Coded;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Quirks;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Game;

/// <summary>
/// A simulated game: a car with a camera drives among traffic through a town or along given roads. It is used through its ports, like the
/// real game; the ground truth about its pictures and lanes is for tests.
/// </summary>
public sealed class SimulatedGame
{
    /// <summary>Moving objects farther away are not drawn, metres.</summary>
    private const double SightRange = 350;

    private readonly HandleCounter _handles = new();
    private SimulationOptions _options;
    private readonly GameSky _sky;
    private SimulatedWorld _world;
    private PicturePainter _painter;
    private readonly Vanishing _vanishing;
    private RayShapes? _rayShapes;
    private readonly Queue<Moment> _toBeShown = [];
    private Moment? _present;
    private MountedView _view;
    private CameraState _cameraBefore;
    private long _state;
    private long _rayState = -1;

    /// <summary>Builds the world.</summary>
    /// <exception cref="ArgumentException">No road lies near the start, or the game has no such weather.</exception>
    public SimulatedGame(SimulationOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        _options = options;

        _view = new MountedView(
            new Pose(new Vector3D(0, 2, 0.4), Axes.Identity),
            options.VerticalFovDegrees,
            options.WindowAspect,
            options.Lens
        );
        View = _view;
        _sky = new GameSky(options);
        Enter(0);
        Freezing = new Freezing(options.Seed, options.Quirks);
        Hidden = new LateHiding(options.Seed, options.Quirks);
        _vanishing = new Vanishing(options.Seed, options.Quirks.VanishingFraction);
        Layers = new ScreenLayers(options.Quirks);
        Ports = new GamePorts(
            new WorldPort(this),
            new RayPort(this),
            options.DefersPictures ? new DeferringScreenPort(this) : new ScreenPort(this),
            new PausePort(this),
            new ClockPort(this),
            new MarkersPort(this)
        )
        {
            Car = new CarPort(this),
            MountedCamera = new MountedCameraPort(this),
            RigCamera = new RigCameraPort(this),
            SurfaceRays = new RayPort(this),
            Paint = new PaintPort(this),
            Lights = new LightsPort(this),
            Visibility = new VisibilityPort(this),
            Sky = new SkyPort(this),
            Sheets = new SheetsPort(this),
            Surfaces = new SurfacePort(this),
            Ground = new GroundPort(this),
            Solids = new SolidsPort(this),
            Hud = new HudPort(this),
            Card = new CardPort(this),
            Stage = options.Stage is null ? null : new StagePort(this),
            DrawnOcclusion = options.ReportsTrueOcclusion ? new DrawnOcclusionPort(this) : null,
        };
    }

    /// <summary>The ports of the game, for a harvest.</summary>
    public GamePorts Ports { get; }

    /// <summary>The road network of the world.</summary>
    public RoadNetwork Roads => _world.Roads;

    /// <summary>The stop lines and pedestrian crossings with which the world was painted.</summary>
    public IReadOnlyList<PaintedMark> Marks => _world.Marks;

    /// <summary>The ground truth of the lanes.</summary>
    public RoadTruth Truth => _world.Truth;

    /// <summary>Whether the world is frozen.</summary>
    public bool IsFrozen => Freezing.IsStanding;

    /// <summary>
    /// Whether no indicator shows what the ego has to do: in a junction, and where it must stop at a line ahead, for a light or to give
    /// way. Its built-in driver knows; an external driver does not.
    /// </summary>
    public bool NeedsOwnDriver => _world.NeedsOwnDriver;

    /// <summary>How the ego has driven since this was first read, or since it came to the place, and where its route leads.</summary>
    public EgoConduct Conduct => _world.Conduct;

    /// <summary>
    /// The camera's pose on the car: by default 2 m ahead of its origin and 0.4 m above it. A change takes effect in the next tick.
    /// </summary>
    public Pose CameraMount
    {
        get => View.Mount;
        set => View = View with { Mount = value };
    }

    /// <summary>The ground truth of the current picture, whatever the ports report: camera, ego, all entities and the tick.</summary>
    public SceneSnapshot Shown => MomentShown.Truth;

    /// <summary>Number of the place that the game visits, from 0.</summary>
    public int Place { get; private set; }

    internal Freezing Freezing { get; }

    /// <summary>The entities that the harvest hides from the pictures.</summary>
    internal LateHiding Hidden { get; }

    /// <summary>What lies over the picture.</summary>
    internal ScreenLayers Layers { get; }

    /// <summary>The faults of this game.</summary>
    internal GameQuirks Quirks => _options.Quirks;

    internal RenderLens Lens => _view.Lens;

    /// <summary>The camera as it will be in the next tick.</summary>
    internal MountedView View { get; set; }

    internal SimulatedWorld World => _world;

    /// <summary>
    /// The impacts of the last tick in which the world moved: who hit whom, where, and the impulse; empty without crashes.
    /// </summary>
    internal IReadOnlyList<Impact> Impacts => _world.Impacts;

    /// <summary>Balls that are shown in addition to the world.</summary>
    internal IReadOnlyList<PlannedMarker> Markers
    {
        get;
        set => (field, _state) = (value, _state + 1);
    } = [];

    /// <summary>Sheets that are shown in addition to the world; they cast no shadows.</summary>
    internal IReadOnlyList<ScreenSheet> Sheets
    {
        get;
        set => (field, _state) = (value, _state + 1);
    } = [];

    internal long GameFrame { get; private set; }

    internal double ElapsedSeconds { get; private set; }

    internal EnvironmentState Environment => _sky.EnvironmentAt(_world.TimeSeconds);

    internal CameraState ReportedCamera => _options.Quirks.IsCameraReportedLate ? _cameraBefore : Camera;

    internal RenderScene ShapesForRays
    {
        get
        {
            if (_rayShapes is null)
            {
                return Present.SceneIn(_world.Scene);
            }

            if (_rayState != _state)
            {
                _rayShapes.Show(Present.Moving, Camera.Pose.Position, IsVehicle, _state);
                _rayState = _state;
            }

            return _rayShapes.Scene;
        }
    }

    private CameraState Camera => new(_world.Ego.Pose.Compose(_view.Mount), _view.VerticalFovDegrees, _options.NearClip, _view.Aspect);

    /// <summary>The present moment, which rays meet and which a frozen game shows.</summary>
    internal Moment Present
    {
        get
        {
            if (_present?.State != _state)
            {
                _world.IsDark = _sky.IsDarkAt(_world.TimeSeconds);
                Vector3D eye = Camera.Pose.Position;
                _present = new Moment(
                    _state,
                    new SceneSnapshot(
                        GameFrame,
                        _world.TimeSeconds,
                        Camera,
                        _world.EgoState,
                        _world.EntitiesNear(eye, double.PositiveInfinity),
                        Environment
                    ),
                    [.. _world.MovingNear(eye, SightRange), .. Markers.Select(MarkerModel.Of), .. Sheets.Select(SheetModel.Of)],
                    _sky.LightAt(_world.TimeSeconds),
                    _world.LightsNear(eye)
                )
                {
                    Hidden = Hidden.Current,
                    Lens = _view.Lens,
                    ShadowsRemain = _options.Quirks.ShadowsRemain,
                };
            }

            if (_present.Truth.GameFrame != GameFrame)
            {
                _present = _present with { Truth = _present.Truth with { GameFrame = GameFrame } };
            }

            return _present;
        }
    }

    /// <summary>The moment that the current picture shows.</summary>
    internal Moment Picture => MomentShown;

    private Moment MomentShown => _toBeShown.TryPeek(out Moment? oldest) ? oldest : Present;

    /// <summary>
    /// Begins to build the models of all games on another thread. The first game waits for them, or builds them if this was not called.
    /// </summary>
    public static void BeginModels() => _ = Task.Run(static () => ModelCatalogue.Shared);

    /// <summary>Whether a point is inside the body of the car.</summary>
    /// <param name="point">The point in the frame of the car's model, metres.</param>
    public bool IsInsideCar(Vector3D point) => EgoBody.Encloses(_world.Ego, point);

    /// <summary>Goes to another place, whose entities have handles of their own, while the time of day stands still.</summary>
    /// <param name="near">Where the ego starts, metres, world x and y.</param>
    /// <exception cref="ArgumentException">No road or no lane lies there.</exception>
    public void GoTo(Vector2D near)
    {
        _options = _options with { Near = near };
        Enter(Place + 1);
    }

    /// <summary>Runs one frame of the game: the world moves unless it is frozen, and the frame is counted.</summary>
    /// <param name="seconds">Real time since the last frame, seconds; greater than 0.</param>
    public void Tick(double seconds)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(seconds);
        _cameraBefore = Camera;
        GameFrame++;
        ElapsedSeconds += seconds;
        double worldSeconds = seconds * Freezing.TakeTick();
        if (worldSeconds > 0)
        {
            _world.SetRain(_sky.RainAt(_world.TimeSeconds));
            _world.Advance(worldSeconds);
            _sky.Fall();
            _state++;
        }

        if (worldSeconds < seconds && Freezing.LetsWeatherGoOn)
        {
            _sky.GoOn(seconds - worldSeconds);
            _sky.Fall();
            _state++;
        }

        if (View != _view && !Freezing.HoldsCamera)
        {
            _view = View;
            _state++;
        }

        _state += Hidden.Tick() ? 1 : 0;
        _state += _sky.Tick() ? 1 : 0;
        _vanishing.Tick(GameFrame);
        Hide();

        if (_options.Quirks.PictureLagTicks > 0)
        {
            _toBeShown.Enqueue(Present);
            if (_toBeShown.Count > _options.Quirks.PictureLagTicks + 1)
            {
                _toBeShown.Dequeue();
            }
        }
    }

    /// <summary>Changes one thing in the world, from the next tick on; the same game without the call goes on as it would have.</summary>
    /// <exception cref="ArgumentException">There is no such vehicle, person or weather.</exception>
    public void Make(WorldChange change)
    {
        ArgumentNullException.ThrowIfNull(change);
        if (change.Kind == WorldChangeKind.Weather)
        {
            SetEnvironment(change.Weather, null);
        }
        else
        {
            _world.Make(change);
            _state++;
        }
    }

    /// <summary>Sets the state of a traffic light until the next call; traffic does not obey it, as in the game.</summary>
    /// <param name="light">The light's handle.</param>
    /// <param name="state">Null or unknown gives the light back to the game.</param>
    public void DriveLight(int light, LightState? state)
    {
        if (state is null or LightState.Unknown)
        {
            _world.DrivenLights.Remove(light);
        }
        else
        {
            _world.DrivenLights[light] = state.Value.AsSignal();
        }

        _state++;
    }

    /// <summary>Renders the current picture, with the handle and depth of each pixel; it is overwritten by the next one.</summary>
    public RenderTarget Render(ImageSize size) => _painter.Paint(MomentShown, size);

    /// <summary>The normals of the current picture; see <see cref="Renderer.NormalsOfLast"/>.</summary>
    internal Vector3[] RenderNormals(ImageSize size) => _painter.Normals(MomentShown, size);

    /// <summary>Renders the current state without some entities, for a comparison; nothing of the game changes.</summary>
    internal RenderTarget RenderWithout(IReadOnlyCollection<int> hidden, ImageSize size)
    {
        Moment now = Present;
        var moment = new Moment(now.State, now.Truth, now.Moving, now.Lighting, now.Lights) { Hidden = hidden, Lens = now.Lens };
        return new PicturePainter(_world.Scene, Detail.Plain, new PictureNoise(0, new GameQuirks())).Paint(moment, size);
    }

    /// <summary>Draws the current picture as the screen shows it, with noise and what lies over it.</summary>
    internal void Show(PixelBuffer target)
    {
        _painter.Show(MomentShown, target);
        Layers.Apply(target, Freezing.FrozenTicks);
    }

    /// <summary>Renders the current picture on another thread, while the world moves on.</summary>
    internal Task RenderLater(PixelBuffer target) => _painter.PaintLater(MomentShown, target);

    /// <summary>Notes that the present state has changed without a tick.</summary>
    internal T Changed<T>(T result)
    {
        _state++;
        return result;
    }

    /// <summary>Places the ego at a position, even while the world is frozen.</summary>
    internal void ResetEgo(Vector3D position, double headingDegrees)
    {
        _world.ResetEgo(position, headingDegrees);
        _state++;
    }

    /// <summary>Sets weather, time of day or both; null leaves a value unchanged.</summary>
    internal void SetEnvironment(string? weather, TimeSpan? timeOfDay)
    {
        _sky.Set(weather, timeOfDay, _world.TimeSeconds);
        _state++;
    }

    /// <summary>Sets weather and time of day until they are restored; null for those before.</summary>
    internal void SetSky(string? weather, TimeSpan? timeOfDay)
    {
        _sky.Replace(weather, timeOfDay, _world.TimeSeconds);
        _state++;
    }

    /// <summary>Gives weather and time of day back as they were before they were set.</summary>
    internal void RestoreSky()
    {
        if (_sky.Restore(_world.TimeSeconds))
        {
            _state++;
        }
    }

    internal IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range)
    {
        _world.IsDark = _sky.IsDarkAt(_world.TimeSeconds);
        List<EntityState> entities = _world.EntitiesNear(centre, range);
        if (Quirks.ModelMarginMetres > 0)
        {
            var margin = new Vector3D(Quirks.ModelMarginMetres, Quirks.ModelMarginMetres, Quirks.ModelMarginMetres);
            entities =
            [
                .. entities.Select(entity => entity with { ModelMin = entity.ModelMin - margin, ModelMax = entity.ModelMax + margin }),
            ];
        }

        if (
            _options.Quirks.VanishingFraction > 0
            && _vanishing.AfterReading([.. entities.Where(entity => IsVehicle(entity.Handle)).Select(entity => entity.Handle)], GameFrame)
        )
        {
            Hide();
        }

        return entities;
    }

    [MemberNotNull(nameof(_world), nameof(_painter), nameof(_cameraBefore))]
    private void Enter(int place)
    {
        double before = place == 0 ? 0 : _world!.TimeSeconds;
        _world = new SimulatedWorld(_options, _handles, place, before);
        Place = place;
        _sky.GoOn(before - _world.TimeSeconds);
        _painter = new PicturePainter(_world.Scene, _options.Detail, new PictureNoise(_options.Seed, _options.Quirks));
        _rayShapes = RayShapes.AreNeededFor(_options.Quirks) ? new RayShapes(_options.Quirks, _options.Seed, _world.Scene) : null;
        _toBeShown.Clear();
        _cameraBefore = Camera;
        _state++;
    }

    private bool IsVehicle(int handle) => _world.IsVehicle(handle);

    private void Hide()
    {
        int hidden =
            _vanishing.Handle != 0 ? _vanishing.Handle
            : Freezing.HidesVehicle ? _world.VehicleNearest(Camera.Pose.Position)
            : 0;
        if (hidden != _world.HiddenHandle)
        {
            _world.HiddenHandle = hidden;
            _state++;
        }
    }
}
