using GTA.Hosting;
using Harvester.Capture.Ports;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Mod.Tests.Games;

/// <summary>A simulated town behind the test game: its entities, camera and rays are what the natives answer.</summary>
internal sealed class SimulatedScene
{
    private const double SecondsOfAFrame = 0.05;

    private readonly SimulatedGame _simulation;
    private readonly SinglePrecisionWorld _world;
    private readonly HashSet<int> _handles = [];

    public SimulatedScene(SimulationOptions options, FaceTable faces)
    {
        _simulation = new SimulatedGame(options);
        _world = new SinglePrecisionWorld(_simulation.Ports.World, faces);
        Ports = _simulation.Ports with { World = _world, Rays = new SinglePrecisionRays(_simulation.Ports.Rays), Markers = null };
    }

    /// <summary>The scene without the mod between; as in the mod there are no markers to calibrate by.</summary>
    public GamePorts Ports { get; }

    /// <summary>The roads of the town.</summary>
    public RoadNetwork Roads => _simulation.Roads;

    public void NextFrame() => _simulation.Tick(SecondsOfAFrame);

    /// <summary>Makes this the world of a test game, with the player at the wheel.</summary>
    public void PlayIn(TestGame game)
    {
        game.SceneCamera = _simulation.Ports.World.ReadCamera;
        game.SceneRays = _simulation.Ports.Rays;
        game.PassFrame = () =>
        {
            NextFrame();
            Show(game);
        };
        game.FreezeChanged = Freeze;
        game.LightDriven = (light, value) =>
            _simulation.DriveLight(
                light,
                value switch
                {
                    0 => LightState.Green,
                    1 => LightState.Red,
                    2 => LightState.Amber,
                    _ => null,
                }
            );
        game.BallsDrawn = _simulation.Ports.Markers!.Show;
        Show(game);
    }

    private void Freeze(FreezeMethod method, bool isFrozen)
    {
        IPause pause = _simulation.Ports.Pause;
        pause.Method = method;
        if (isFrozen)
        {
            pause.Freeze();
        }
        else
        {
            pause.Unfreeze();
        }
    }

    private void Show(TestGame game)
    {
        foreach (int handle in _handles)
        {
            game.Entities.Remove(handle);
        }

        _handles.Clear();
        EgoState ego = _simulation.Ports.World.ReadEgo();
        Put(
            game,
            new EntityState(ego.Handle, ObjectClass.Car, ego.Model, ego.Pose, default, default, ego.Velocity),
            ego.HeightAboveGroundMetres ?? 0
        );
        foreach (EntityState entity in _world.Unrounded())
        {
            Put(game, entity);
        }

        game.PlayersVehicle = ego.Handle;
        game.Frame = (int)_world.GameFrame;
        game.TimerMilliseconds = _world.Milliseconds;
        game.Environment = _world.ReadEnvironment();
    }

    private void Put(TestGame game, EntityState entity, double heightAboveGround = 0)
    {
        _handles.Add(entity.Handle);
        game.Entities[entity.Handle] = new GameEntity
        {
            Pool = entity.Class switch
            {
                ObjectClass.Pedestrian or ObjectClass.Rider => PoolKind.Peds,
                ObjectClass.Sign or ObjectClass.TrafficLight or ObjectClass.Other => PoolKind.Props,
                _ => PoolKind.Vehicles,
            },
            Name = entity.Model,
            Hash = ModelHash.TryParse(entity.Model, out int hash) ? hash : ModelHash.Of(entity.Model),
            VehicleClass = entity.Class switch
            {
                ObjectClass.Motorcycle => 8,
                ObjectClass.Trailer => 11,
                ObjectClass.Bicycle => 13,
                ObjectClass.Bus => 17,
                ObjectClass.Truck => 20,
                _ => 1,
            },
            Pose = entity.Pose,
            ModelMin = entity.ModelMin,
            ModelMax = entity.ModelMax,
            Velocity = entity.Velocity,
            HeightAboveGround = heightAboveGround,
            Skeleton = entity.Skeleton,
            Vehicle = entity.VehicleHandle ?? 0,
        };
    }
}
