using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Play.Features;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod;

/// <summary>What the harvest reads of the game. Everything except the lists of nearby entities comes from natives.</summary>
internal sealed class GameWorld : IStepwiseWorld, IProps
{
    /// <summary>Peds farther from the camera have no joints: they are smaller than 12 pixels in an image of 800 x 600, as in JTA.</summary>
    private const double JointRangeMetres = 100;

    /// <summary>Peds so far behind the camera are not in its image, nor any part of them.</summary>
    private const double BehindMetres = 2;

    /// <summary>A ped reaches less far from its position, also with its arms stretched out, metres.</summary>
    private const double PedReachMetres = 2;

    /// <summary>Factor on the extent of the view, for lenses that show more than a pinhole camera.</summary>
    private const double ViewMargin = 1.25;

    private readonly CameraMount _mount;
    private readonly GameTime _time;
    private readonly GameRays _rays;
    private readonly IModels _models;
    private readonly Func<FaceTable> _faces;
    private readonly ReadingRecord _reading;
    private readonly NearbyEntities _nearby;
    private readonly PedBones _bones = new();
    private readonly StillEntities _still = new();
    private CameraState? _camera;
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
    public GameWorld(
        CameraMount mount,
        GameTime time,
        GameRays rays,
        IModels models,
        Func<FaceTable> faces,
        NearbyEntities nearby,
        ReadingRecord reading
    )
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

    /// <summary>Whether cameras look in other directions than the one read last, so that joints outside its view count too.</summary>
    public Func<bool> LooksAround { get; init; } = static () => false;

    /// <inheritdoc/>
    public long GameFrame => Natives.Call<int>(Hash.GET_FRAME_COUNT);

    /// <inheritdoc/>
    public double TimeSeconds => _time.Seconds;

    /// <inheritdoc/>
    public CameraState ReadCamera() => _camera = RenderedCamera.Read();

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
        WorkRun.Complete(ReadEntitiesInSteps(centre, range, entities));
        return entities;
    }

    /// <inheritdoc/>
    public IEnumerable<WorkStep> ReadEntitiesInSteps(Vector3D centre, double range, List<EntityState> entities)
    {
        var joints = new WorkResult<Skeleton>();
        // Each native is called once: on release 3.6.0 one takes about 19 microseconds, and a street has dozens of peds.
        _still.Begin(TimeSeconds);
        int player = Natives.PlayerPed();
        var occupied = new HashSet<int>();
        foreach (int ped in Near(EntityKind.Ped, centre, range))
        {
            ScaledPose? place = Natives.EntityMatrix(ped);
            PedRole? known = place is { } still ? _still.RoleOf(ped, still) : null;
            PedRole role = known ?? RoleOf(ped, player);
            if (known is null)
            {
                yield return WorkStep.Pause;
                if (place is { } at)
                {
                    _still.Add(ped, at, role);
                }
            }

            if (role.Vehicle is { } boarded)
            {
                occupied.Add(boarded);
            }

            EntityState? state = role.IsLabelled ? Read(ped, EntityKind.Ped, place) : null;
            if (state is not null && role.Vehicle is { } ridden)
            {
                state = state with { Class = ObjectClass.Rider, VehicleHandle = ridden };
            }

            if (state is not null && IsForJoints(state, centre) && _bones.HasAll(ped))
            {
                yield return WorkStep.Do(PedBones.ReadInSteps(ped, _still.JointsOf(ped), joints));
                _still.Add(ped, joints.Value!);
                state = state with { Skeleton = joints.Value };

                // The bones of a ped that has disappeared meanwhile are at the world's origin.
                state = Natives.EntityExists(ped) ? state : null;
            }

            Add(state);
            yield return WorkStep.Pause;
        }

        foreach (int machine in Near(EntityKind.Vehicle, centre, range))
        {
            EntityState? state = Read(machine, EntityKind.Vehicle, Natives.EntityMatrix(machine));
            Add(state is not null && VehicleClasses.HaveRiders(state.Class) ? state with { HasRider = occupied.Contains(machine) } : state);
            yield return WorkStep.Pause;
        }

        foreach (int prop in Near(EntityKind.Prop, centre, range))
        {
            Add(Read(prop, EntityKind.Prop, Natives.EntityMatrix(prop)));
            yield return WorkStep.Pause;
        }

        void Add(EntityState? state)
        {
            if (state is not null)
            {
                entities.Add(state);
            }
        }
    }

    /// <inheritdoc/>
    public int PlayersBody => Natives.PlayerPed();

    /// <inheritdoc/>
    public EntityState? ReadProp(int entity)
    {
        const int prop = 3;
        TakeTable();
        _still.Begin(TimeSeconds);
        return Natives.Call<int>(Hash.GET_ENTITY_TYPE, entity) == prop ? Read(entity, EntityKind.Prop, Natives.EntityMatrix(entity)) : null;
    }

    /// <inheritdoc/>
    public IReadOnlyList<EntityState> ReadProps(Vector3D centre, double range) =>
        [.. _nearby.AllProps(centre, range).Select(ReadProp).OfType<EntityState>()];

    /// <inheritdoc/>
    public EnvironmentState ReadEnvironment() =>
        new(
            WeatherNames.Of(Natives.Call<int>(Hash.GET_PREV_WEATHER_TYPE_HASH_NAME)),
            new TimeSpan(
                Natives.Call<int>(Hash.GET_CLOCK_HOURS),
                Natives.Call<int>(Hash.GET_CLOCK_MINUTES),
                Natives.Call<int>(Hash.GET_CLOCK_SECONDS)
            )
        );

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

    /// <summary>What a ped is to the labels. Who is seen through the windows of a vehicle belongs to it.</summary>
    private PedRole RoleOf(int ped, int player)
    {
        if (!Natives.EntityExists(ped))
        {
            return default;
        }

        int? vehicle = Natives.IsInVehicle(ped) ? Natives.VehicleSeating(ped) : null;
        bool isSeen = vehicle is not { } boarded || IsRidden(boarded);
        return new PedRole(vehicle, isSeen && ped != player && Natives.IsHuman(ped));
    }

    /// <summary>Whether those on a vehicle sit on it and are seen: on a two-wheeler other than the one that carries the camera.</summary>
    private bool IsRidden(int vehicle) =>
        vehicle != _mount.Vehicle && Natives.EntityExists(vehicle) && VehicleClasses.HaveRiders(FactsOf(EntityKind.Vehicle, vehicle).Class);

    /// <summary>Whether the joints of a ped may be in the image of the camera read last.</summary>
    private bool IsForJoints(EntityState ped, Vector3D centre) =>
        (ped.Pose.Position - centre).Length < JointRangeMetres
        && (
            _camera is not { } camera
            || (LooksAround() ? camera.Pose.ToLocal(ped.Pose.Position).Y > -BehindMetres : MayBeInView(camera, ped.Pose.Position))
        );

    /// <summary>
    /// Whether a ped may reach into the view. At the depth y, the view extends t y to each side, t being the tangent of half its angle; a
    /// ball of radius r around the ped reaches into it if the ped is less than r / cos = r √(1 + t²) farther away, measured sideways.
    /// </summary>
    private static bool MayBeInView(CameraState camera, Vector3D position)
    {
        Vector3D local = camera.Pose.ToLocal(position);
        double up = ViewMargin * Math.Tan(Angles.ToRadians(camera.VerticalFovDegrees) / 2);
        return local.Y > -PedReachMetres && IsWithin(local.Z, up) && IsWithin(local.X, up * camera.WindowAspect);

        bool IsWithin(double aside, double tangent) =>
            Math.Abs(aside) - (tangent * local.Y) < PedReachMetres * Math.Sqrt(1 + (tangent * tangent));
    }

    /// <summary>Rebuilds the known models if the table in use has changed.</summary>
    private void TakeTable()
    {
        FaceTable table = _faces();
        if (table != _table)
        {
            _table = table;
            _known = new KnownModels(_models, table);
            _still.Clear();
            _nearby.PropModels = [.. table.Faces.Select(face => face.Hash).Distinct()];
        }
    }

    /// <summary>The current state of an entity; null if it no longer exists, even if it disappears while it is read.</summary>
    /// <param name="handle">The entity.</param>
    /// <param name="kind">Its kind.</param>
    /// <param name="place">Its matrix; null if no rotation and scale give it.</param>
    private EntityState? Read(int handle, EntityKind kind, ScaledPose? place)
    {
        try
        {
            if (place is not { } matrix)
            {
                if (Natives.EntityExists(handle))
                {
                    _reading.AddDistorted(handle);
                }

                return null;
            }

            if (_still.Of(handle, matrix) is { } known)
            {
                return known;
            }

            if (!Natives.EntityExists(handle))
            {
                return null;
            }

            ModelFacts model = FactsOf(kind, handle);
            var state = new EntityState(
                handle,
                model.Class,
                model.Name,
                matrix.Pose,
                matrix.Stretch(model.Min),
                matrix.Stretch(model.Max),
                Natives.EntityVelocity(handle)
            );
            _still.Add(matrix, state);
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
