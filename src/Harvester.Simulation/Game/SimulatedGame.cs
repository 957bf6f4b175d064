using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Quirks;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
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

    private readonly SimulationOptions _options;
    private readonly WeatherClock _weather;
    private readonly SimulatedWorld _world;
    private readonly Renderer _renderer = new();
    private readonly Vanishing _vanishing;
    private readonly RayShapes? _rayShapes;
    private readonly Queue<Moment> _toBeShown = [];
    private RenderTarget? _picture;
    private Moment? _present;
    private Pose _mount = new(new Vector3D(0, 2, 0.4), Axes.Identity);
    private CameraState _cameraBefore;
    private double _weatherAheadSeconds;
    private long _state;
    private int _precipitation;
    private long _pictureState = -1;
    private long _sceneState = -1;
    private long _rayState = -1;

    /// <summary>Builds the world.</summary>
    /// <exception cref="ArgumentException">No road lies near the start, or the game has no such weather.</exception>
    public SimulatedGame(SimulationOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        _options = options;

        // A wrong name is found before a world is built.
        _weather = new WeatherClock(options);
        _world = new SimulatedWorld(options);
        Freezing = new Freezing(options.Seed, options.Quirks);
        _vanishing = new Vanishing(options.Seed, options.Quirks.VanishingFraction);
        _rayShapes = RayShapes.AreNeededFor(options.Quirks) ? new RayShapes(options.Quirks, options.Seed, _world.Scene) : null;
        CameraMount = _mount;
        _cameraBefore = Camera;
        Ports = new GamePorts(
            new WorldPort(this), new RayPort(this), new ScreenPort(this), new PausePort(this), new ClockPort(this), new MarkersPort(this))
        {
            Car = new CarPort(this),
            MountedCamera = new MountedCameraPort(this),
            Paint = new PaintPort(_world.Paint),
            Lights = new LightsPort(this),
        };
    }

    /// <summary>The ports of the game, for a harvest.</summary>
    public GamePorts Ports { get; }

    /// <summary>The road network of the world.</summary>
    public RoadNetwork Roads => _world.Roads;

    /// <summary>The ground truth of the lanes.</summary>
    public RoadTruth Truth => _world.Truth;

    /// <summary>Whether the world is frozen.</summary>
    public bool IsFrozen => Freezing.IsStanding;

    /// <summary>
    /// Whether the ego must stop at a line ahead, for a light or to give way. Its built-in driver does; an external driver need not.
    /// </summary>
    public bool MustEgoGiveWay => _world.MustEgoGiveWay;

    /// <summary>
    /// The camera's pose on the car: by default 2 m ahead of its origin and 0.4 m above it. A change takes effect in the next tick.
    /// </summary>
    public Pose CameraMount { get; set; }

    /// <summary>The ground truth of the current picture, whatever the ports report: camera, ego, all entities and the tick.</summary>
    public SceneSnapshot Shown => MomentShown.Truth;

    internal Freezing Freezing { get; }

    internal SimulatedWorld World => _world;

    /// <summary>Balls that are shown in addition to the world.</summary>
    internal IReadOnlyList<PlannedMarker> Markers
    {
        get;
        set
        {
            field = value;
            _state++;
        }
    } = [];

    internal long GameFrame { get; private set; }

    internal double ElapsedSeconds { get; private set; }

    internal EnvironmentState Environment => _weather.At(WeatherSeconds);

    internal CameraState ReportedCamera => _options.Quirks.IsCameraReportedLate ? _cameraBefore : Camera;

    internal RenderScene ShapesForRays
    {
        get
        {
            if (_rayShapes is null)
            {
                Load(Present);
                return _world.Scene;
            }

            if (_rayState != _state)
            {
                _rayShapes.Show(Present.Moving, Camera.Pose.Position, IsVehicle, _state);
                _rayState = _state;
            }

            return _rayShapes.Scene;
        }
    }

    /// <summary>The world's time for time of day and weather, which may continue in a frozen world.</summary>
    private double WeatherSeconds => _world.TimeSeconds + _weatherAheadSeconds;

    private CameraState Camera =>
        new(_world.Ego.Pose.Compose(_mount), _options.VerticalFovDegrees, _options.NearClip, _options.WindowAspect);

    private Moment Present
    {
        get
        {
            if (_present?.State != _state)
            {
                Vector3D eye = Camera.Pose.Position;
                _present = new Moment(
                    _state,
                    new SceneSnapshot(GameFrame, _world.TimeSeconds, Camera, _world.EgoState,
                        _world.EntitiesNear(eye, double.PositiveInfinity), Environment),
                    [.. _world.MovingNear(eye, SightRange), .. Markers.Select(MarkerModel.Of)],
                    _weather.LightingAt(WeatherSeconds) with { PrecipitationSeed = _precipitation },
                    _world.LightsNear(eye));
            }

            if (_present.Truth.GameFrame != GameFrame)
            {
                _present = _present with { Truth = _present.Truth with { GameFrame = GameFrame } };
            }

            return _present;
        }
    }

    private Moment MomentShown => _toBeShown.TryPeek(out Moment? oldest) ? oldest : Present;

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
            _world.Advance(worldSeconds);
            _precipitation++;
            _state++;
        }

        if (worldSeconds < seconds && Freezing.LetsWeatherGoOn)
        {
            _weatherAheadSeconds += seconds - worldSeconds;
            _precipitation++;
            _state++;
        }

        if (CameraMount != _mount && !Freezing.HoldsCamera)
        {
            _mount = CameraMount;
            _state++;
        }

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
    public RenderTarget Render(ImageSize size)
    {
        if (_picture is null || _picture.Width != size.Width || _picture.Height != size.Height)
        {
            _picture = new RenderTarget(size.Width, size.Height);
            _pictureState = -1;
        }

        Moment shown = MomentShown;
        if (_pictureState != shown.State)
        {
            Load(shown);
            CameraState camera = shown.Truth.Camera;
            RenderCamera eye = new(camera.Pose, camera.VerticalFovDegrees, camera.WindowAspect, camera.NearClip, size.Width, size.Height)
            {
                Lens = _options.Lens,
            };
            _renderer.Render(_world.Scene, eye, _picture);
            _pictureState = shown.State;
        }

        return _picture;
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
        _weather.Set(weather, timeOfDay, WeatherSeconds);
        _state++;
    }

    internal IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range)
    {
        List<EntityState> entities = _world.EntitiesNear(centre, range);
        if (_options.Quirks.VanishingFraction > 0
            && _vanishing.AfterReading([.. entities.Where(entity => IsVehicle(entity.Handle)).Select(entity => entity.Handle)], GameFrame))
        {
            Hide();
        }

        return entities;
    }

    private bool IsVehicle(int handle) => handle >= _world.Vehicles[0].Handle && handle <= _world.Vehicles[^1].Handle;

    private void Hide()
    {
        int hidden = _vanishing.Handle != 0 ? _vanishing.Handle : Freezing.HidesVehicle ? _world.VehicleNearest(Camera.Pose.Position) : 0;
        if (hidden != _world.HiddenHandle)
        {
            _world.HiddenHandle = hidden;
            _state++;
        }
    }

    private void Load(Moment moment)
    {
        if (_sceneState != moment.State)
        {
            _world.Scene.SetDynamic(moment.Moving);
            _world.Scene.Lighting = moment.Lighting;
            _world.Scene.Lights = moment.Lights;
            _sceneState = moment.State;
        }
    }
}
