using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using GTA;
using GTA.Math;
using GTA.Native;
using Harvester.Capture.Playing;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Capture.Spaces;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>What the harvest reads of the game. Only the lists of what is near come from the API's memory; all else is natives.</summary>
internal sealed class GameWorld : IWorld, IProps
{
    private readonly CameraMount _mount;
    private readonly GameTime _time;
    private readonly GameRays _rays;
    private readonly IModels _models;
    private readonly Func<SpaceTable> _spaces;
    private SpaceTable _table = SpaceTable.Empty;
    private KnownModels _known;
    private Model[] _props = [];

    /// <summary>Reads the game around a camera.</summary>
    /// <param name="mount">The camera and the vehicle that carries it.</param>
    /// <param name="time">The game's time.</param>
    /// <param name="rays">Where the entities are made known.</param>
    /// <param name="models">The game's models.</param>
    /// <param name="spaces">Gives the models of signs and traffic lights that are in use: the only props that are read.</param>
    public GameWorld(CameraMount mount, GameTime time, GameRays rays, IModels models, Func<SpaceTable> spaces)
    {
        _mount = mount;
        _time = time;
        _rays = rays;
        _models = models;
        _spaces = spaces;
        _known = new KnownModels(models, _table);
    }

    /// <inheritdoc/>
    public long GameFrame => Natives.Call<int>(Hash.GET_FRAME_COUNT);

    /// <inheritdoc/>
    public double TimeSeconds => _time.Seconds;

    /// <inheritdoc/>
    public CameraState ReadCamera()
    {
        Vector3D degrees = Natives.ToWorld(Natives.Call<Vector3>(Hash.GET_FINAL_RENDERED_CAM_ROT, Natives.RotationOrder));
        return new CameraState(
            new Pose(
                Natives.ToWorld(Natives.Call<Vector3>(Hash.GET_FINAL_RENDERED_CAM_COORD)),
                Axes.FromEuler(new EulerAngles(degrees.X, degrees.Y, degrees.Z))),
            Natives.Call<float>(Hash.GET_FINAL_RENDERED_CAM_FOV),
            Natives.Call<float>(Hash.GET_FINAL_RENDERED_CAM_NEAR_CLIP),
            Natives.Call<float>(Hash.GET_ASPECT_RATIO, false));
    }

    /// <inheritdoc/>
    public EgoState ReadEgo()
    {
        int vehicle = _mount.Vehicle;
        ModelFacts model = _known.OfVehicle(vehicle, Natives.EntityModel(vehicle));
        return new EgoState(vehicle, model.Name, Natives.EntityPose(vehicle), Natives.EntityVelocity(vehicle))
        {
            ModelMin = model.Min,
            ModelMax = model.Max,
        };
    }

    /// <inheritdoc/>
    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range)
    {
        TakeTable();
        Vector3 place = PlaceOf(centre);
        float radius = (float)range;
        var entities = new List<EntityState>();
        Add(World.GetNearbyVehicles(place, radius).Select(vehicle => vehicle.Handle).Where(vehicle => vehicle != _mount.Vehicle), _known.OfVehicle);
        Add(World.GetNearbyPeds(place, radius).Select(ped => ped.Handle).Where(IsOnFoot), (_, hash) => _known.OfPed(hash));
        if (_props.Length > 0)
        {
            Add(World.GetNearbyProps(place, radius, _props).Select(prop => prop.Handle), (_, hash) => _known.OfProp(hash));
        }

        return entities;

        void Add(IEnumerable<int> handles, Func<int, int, ModelFacts> describe) =>
            entities.AddRange(handles.Select(handle => Read(handle, describe)).OfType<EntityState>());
    }

    /// <inheritdoc/>
    public int PlayersBody => Natives.PlayerPed();

    /// <inheritdoc/>
    public EntityState? ReadProp(int entity)
    {
        const int prop = 3;
        TakeTable();
        return Natives.Call<int>(Hash.GET_ENTITY_TYPE, entity) == prop ? Read(entity, (_, hash) => _known.OfProp(hash)) : null;
    }

    /// <inheritdoc/>
    public IReadOnlyList<EntityState> ReadProps(Vector3D centre, double range) =>
        [.. World.GetNearbyProps(PlaceOf(centre), (float)range).Select(prop => ReadProp(prop.Handle)).OfType<EntityState>()];

    /// <inheritdoc/>
    public EnvironmentState ReadEnvironment() => new(
        WeatherNames.Of(Natives.Call<int>(Hash.GET_PREV_WEATHER_TYPE_HASH_NAME)),
        new TimeSpan(Natives.Call<int>(Hash.GET_CLOCK_HOURS), Natives.Call<int>(Hash.GET_CLOCK_MINUTES), Natives.Call<int>(Hash.GET_CLOCK_SECONDS)));

    private static Vector3 PlaceOf(Vector3D centre) => new((float)centre.X, (float)centre.Y, (float)centre.Z);

    private static bool IsOnFoot(int ped) =>
        Natives.EntityExists(ped) && ped != Natives.PlayerPed() && Natives.Call<bool>(Hash.IS_PED_HUMAN, ped) && Natives.VehicleOf(ped) == 0;

    /// <summary>What is known of models stems from the table in use, which may have become another since.</summary>
    private void TakeTable()
    {
        SpaceTable table = _spaces();
        if (table != _table)
        {
            _table = table;
            _known = new KnownModels(_models, table);
            _props = [.. table.Spaces.Select(space => space.Hash).Distinct().Select(hash => new Model(hash))];
        }
    }

    /// <summary>An entity as it is now; null when it is gone, be it in the middle of reading.</summary>
    private EntityState? Read(int handle, Func<int, int, ModelFacts> describe)
    {
        if (!Natives.EntityExists(handle))
        {
            return null;
        }

        try
        {
            ModelFacts model = describe(handle, Natives.EntityModel(handle));
            var state = new EntityState(
                handle, model.Class, model.Name, Natives.EntityPose(handle), model.Min, model.Max, Natives.EntityVelocity(handle));
            _rays.Know(handle);
            return state;
        }
        catch (Exception exception) when (exception is not ThreadAbortException && !Natives.EntityExists(handle))
        {
            // A matrix of zeros, for one.
            return null;
        }
    }
}
