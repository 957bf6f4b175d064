using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Models;
using Harvester.Simulation.Ports;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.World;

namespace Harvester.Simulation;

/// <summary>
/// A game without GTA: a car drives through a town or along given roads among traffic, with a camera mounted on it.
/// It is used through its ports, as the real one is; the truth about its pictures and lanes is for tests.
/// </summary>
public sealed class SimulatedGame
{
    private const double RealSecondsPerGameMinute = 2;
    private const double SightRange = 350;

    /// <summary>The camera's place on the car: 2 m ahead of its origin and 0.4 m above it.</summary>
    private static readonly Pose CameraMount = new(new Vector3D(0, 2, 0.4), Axes.Identity);

    private readonly SimulationOptions _options;
    private readonly SimulatedWorld _world;
    private readonly Renderer _renderer = new();
    private RenderTarget? _picture;
    private long _state;
    private long _pictureState = -1;
    private long _sceneState = -1;

    /// <summary>Builds the world.</summary>
    /// <exception cref="ArgumentException">No road lies near the start, or the weather is none of the game's.</exception>
    public SimulatedGame(SimulationOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        _options = options;

        // A wrong name is found before a world is built in vain.
        _ = Weather.LightingOf(options.Weather, options.TimeOfDay);
        _world = new SimulatedWorld(options);
        Ports = new GamePorts(new WorldPort(this), new RayPort(this), new ScreenPort(this), new PausePort(this), new ClockPort(this), new MarkersPort(this));
    }

    /// <summary>The game as the harvest sees it.</summary>
    public GamePorts Ports { get; }

    /// <summary>The roads that the world was built on.</summary>
    public RoadNetwork Roads => _world.Roads;

    /// <summary>The lanes that the world was built with.</summary>
    public RoadTruth Truth => _world.Truth;

    /// <summary>Whether the world stands still.</summary>
    public bool IsFrozen { get; internal set; }

    internal SimulatedWorld World => _world;

    /// <summary>Balls that are shown beside what the world holds.</summary>
    internal IReadOnlyList<PlannedMarker> Markers
    {
        get;
        set
        {
            field = value;
            _sceneState = -1;
            _pictureState = -1;
        }
    } = [];

    internal long GameFrame { get; private set; }

    internal double ElapsedSeconds { get; private set; }

    internal EnvironmentState Environment => new(_options.Weather, TimeOfDay);

    internal CameraState Camera =>
        new(_world.Ego.Pose.Compose(CameraMount), _options.VerticalFovDegrees, _options.NearClip, _options.WindowAspect);

    internal RenderScene Scene
    {
        get
        {
            RefreshScene();
            return _world.Scene;
        }
    }

    private TimeSpan TimeOfDay
    {
        get
        {
            double gameMinutes = _options.IsTimeOfDayFixed ? 0 : _world.TimeSeconds / RealSecondsPerGameMinute;
            return TimeSpan.FromTicks((_options.TimeOfDay + TimeSpan.FromMinutes(gameMinutes)).Ticks % TimeSpan.TicksPerDay);
        }
    }

    /// <summary>One frame of the game: the world goes on, unless it is frozen, and the frame is counted.</summary>
    /// <param name="seconds">Time that passes for the player; greater than 0.</param>
    public void Tick(double seconds)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(seconds);
        GameFrame++;
        ElapsedSeconds += seconds;
        if (!IsFrozen)
        {
            _world.Advance(seconds);
            _state++;
        }
    }

    /// <summary>The picture of the present state with the true handle and depth of each pixel; it is overwritten by the next one.</summary>
    public RenderTarget Render(ImageSize size)
    {
        if (_picture is null || _picture.Width != size.Width || _picture.Height != size.Height)
        {
            _picture = new RenderTarget(size.Width, size.Height);
            _pictureState = -1;
        }

        if (_pictureState != _state)
        {
            CameraState camera = Camera;
            _renderer.Render(Scene, new RenderCamera(camera.Pose, camera.VerticalFovDegrees, camera.WindowAspect, camera.NearClip, size.Width, size.Height) { Lens = _options.Lens }, _picture);
            _pictureState = _state;
        }

        return _picture;
    }

    private void RefreshScene()
    {
        if (_sceneState != _state)
        {
            Vector3D eye = Camera.Pose.Position;
            _world.Scene.SetDynamic([.. _world.MovingNear(eye, SightRange), .. Markers.Select(MarkerModel.Of)]);
            _world.Scene.Lighting = Weather.LightingOf(_options.Weather, TimeOfDay) with { PrecipitationSeed = (int)_state };
            _world.Scene.Lights = LightsNear(eye);
            _sceneState = _state;
        }
    }

    private List<LightSource> LightsNear(Vector3D eye)
    {
        const double range = 90;
        const int most = 14;
        const double lampAhead = 2;
        IEnumerable<LightSource> lamps = _world.Lamps
            .Where(lamp => (lamp - eye).Length < range)
            .OrderBy(lamp => (lamp - eye).LengthSquared)
            .Take(most)
            .Select(LightSource.StreetLamp);
        IEnumerable<LightSource> headlights = _world.Vehicles
            .Where(vehicle => (vehicle.Pose.Position - eye).Length < range)
            .OrderBy(vehicle => (vehicle.Pose.Position - eye).LengthSquared)
            .Take(most)
            .Select(vehicle => LightSource.Headlights(vehicle.Pose.ToWorld(new Vector3D(0, lampAhead, 0)), vehicle.Pose.Axes.Forward));
        return [.. lamps, .. headlights];
    }
}
