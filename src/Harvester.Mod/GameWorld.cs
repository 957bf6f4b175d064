using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Features;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod;

/// <summary>What the harvest reads of the game. Everything except the lists of nearby entities comes from natives.</summary>
internal sealed class GameWorld : IWorld, IProps
{
    private readonly CameraMount _mount;
    private readonly GameTime _time;
    private readonly GameRays _rays;
    private readonly IModels _models;
    private readonly Func<FaceTable> _faces;
    private readonly ReadingRecord _reading;
    private readonly NearbyEntities _nearby;
    private FaceTable _table = FaceTable.Empty;
    private KnownModels _known;

    /// <summary>Reads the game around a camera.</summary>
    /// <param name="mount">The camera and the vehicle that carries it.</param>
    /// <param name="time">The game's time.</param>
    /// <param name="rays">Receives the handles of the entities.</param>
    /// <param name="models">The game's models.</param>
    /// <param name="faces">Returns the table of signs and traffic lights in use; no other props are read.</param>
    /// <param name="nearby">Lists the entities.</param>
    /// <param name="reading">Records entities that are left out.</param>
    public GameWorld(CameraMount mount, GameTime time, GameRays rays, IModels models, Func<FaceTable> faces, NearbyEntities nearby,
        ReadingRecord reading)
    {
        _nearby = nearby;
        _reading = reading;
        _mount = mount;
        _time = time;
        _rays = rays;
        _models = models;
        _faces = faces;
        _known = new KnownModels(models, _table);
    }

    /// <inheritdoc/>
    public long GameFrame => Natives.Call<int>(Hash.GET_FRAME_COUNT);

    /// <inheritdoc/>
    public double TimeSeconds => _time.Seconds;

    /// <inheritdoc/>
    public CameraState ReadCamera() => RenderedCamera.Read();

    /// <inheritdoc/>
    public EgoState ReadEgo()
    {
        int vehicle = _mount.Vehicle;
        ModelFacts model = _known.OfVehicle(vehicle, Natives.EntityModel(vehicle));
        return new EgoState(vehicle, model.Name, Natives.EntityPose(vehicle), Natives.EntityVelocity(vehicle))
        {
            ModelMin = model.Min,
            ModelMax = model.Max,
            HeightAboveGroundMetres = vehicle == 0 ? null : Natives.Call<float>(Hash.GET_ENTITY_HEIGHT_ABOVE_GROUND, vehicle),
        };
    }

    /// <inheritdoc/>
    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range)
    {
        var entities = new List<EntityState>();
        var occupied = new HashSet<int>();
        List<int> onFoot = OnFoot(Near(EntityKind.Ped, centre, range), occupied);
        Add(Near(EntityKind.Vehicle, centre, range), EntityKind.Vehicle);
        Add(onFoot, EntityKind.Ped);
        Add(Near(EntityKind.Prop, centre, range), EntityKind.Prop);
        return entities;

        void Add(IEnumerable<int> handles, EntityKind kind) =>
            entities.AddRange(handles.Select(handle => Read(handle, kind)).OfType<EntityState>().Select(WithRider));

        EntityState WithRider(EntityState entity) =>
            VehicleClasses.HaveRiders(entity.Class) ? entity with { HasRider = occupied.Contains(entity.Handle) }
                : entity;
    }

    /// <summary>The persons on foot but for the player; what the others sit in is added to the occupied vehicles.</summary>
    private static List<int> OnFoot(IEnumerable<int> peds, HashSet<int> occupied)
    {
        // Each native is asked once: on release 3.6.0 one takes about 19 microseconds, and a street has dozens of peds.
        int player = Natives.PlayerPed();
        var onFoot = new List<int>();
        foreach (int ped in peds.Where(Natives.EntityExists))
        {
            if (Natives.IsInVehicle(ped))
            {
                occupied.Add(Natives.VehicleSeating(ped));
            }
            else if (ped != player && Natives.IsHuman(ped))
            {
                onFoot.Add(ped);
            }
        }

        return onFoot;
    }

    /// <inheritdoc/>
    public int PlayersBody => Natives.PlayerPed();

    /// <inheritdoc/>
    public EntityState? ReadProp(int entity)
    {
        const int prop = 3;
        TakeTable();
        return Natives.Call<int>(Hash.GET_ENTITY_TYPE, entity) == prop ? Read(entity, EntityKind.Prop) : null;
    }

    /// <inheritdoc/>
    public IReadOnlyList<EntityState> ReadProps(Vector3D centre, double range) =>
        [.. _nearby.AllProps(centre, range).Select(ReadProp).OfType<EntityState>()];

    /// <inheritdoc/>
    public EnvironmentState ReadEnvironment() => new(
        WeatherNames.Of(Natives.Call<int>(Hash.GET_PREV_WEATHER_TYPE_HASH_NAME)),
        new TimeSpan(Natives.Call<int>(Hash.GET_CLOCK_HOURS), Natives.Call<int>(Hash.GET_CLOCK_MINUTES),
            Natives.Call<int>(Hash.GET_CLOCK_SECONDS)));

    /// <summary>
    /// The handles of nearby entities that may be labelled: without the vehicle that carries the camera, and only props with faces.
    /// </summary>
    public IReadOnlyList<int> Near(EntityKind kind, Vector3D centre, double range)
    {
        TakeTable();
        return kind switch
        {
            EntityKind.Vehicle => [.. _nearby.Vehicles(centre, range).Where(vehicle => vehicle != _mount.Vehicle)],
            EntityKind.Ped => _nearby.Peds(centre, range),
            _ => _nearby.Props(centre, range),
        };
    }

    /// <summary>The facts of an entity's model.</summary>
    public ModelFacts FactsOf(EntityKind kind, int entity)
    {
        int hash = Natives.EntityModel(entity);
        return kind switch
        {
            EntityKind.Vehicle => _known.OfVehicle(entity, hash),
            EntityKind.Ped => _known.OfPed(hash),
            _ => _known.OfProp(hash),
        };
    }

    /// <summary>Rebuilds the known models if the table in use has changed.</summary>
    private void TakeTable()
    {
        FaceTable table = _faces();
        if (table != _table)
        {
            _table = table;
            _known = new KnownModels(_models, table);
            _nearby.PropModels = [.. table.Faces.Select(face => face.Hash).Distinct()];
        }
    }

    /// <summary>The current state of an entity; null if it no longer exists, even if it disappears while it is read.</summary>
    private EntityState? Read(int handle, EntityKind kind)
    {
        if (!Natives.EntityExists(handle))
        {
            return null;
        }

        try
        {
            ModelFacts model = FactsOf(kind, handle);
            if (Natives.EntityMatrix(handle) is not { } matrix)
            {
                if (Natives.EntityExists(handle))
                {
                    _reading.AddDistorted(handle);
                }

                return null;
            }

            var state = new EntityState(
                handle, model.Class, model.Name, matrix.Pose, matrix.Stretch(model.Min), matrix.Stretch(model.Max),
                    Natives.EntityVelocity(handle));
            _rays.Know(handle);
            return state;
        }
        catch (Exception exception) when (exception is not ThreadAbortException && !Natives.EntityExists(handle))
        {
            // It disappeared while it was read.
            return null;
        }
    }
}
