using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>Roads with all fixed and moving objects on and beside them.</summary>
internal sealed class SimulatedWorld
{
    private const double MaxTick = 0.05;

    /// <summary>A prime, so that the seeds of a game's places differ from each other and from those of other games.</summary>
    private const int SeedStep = 15_485_863;

    /// <summary>
    /// At every second place the ego is asked to drift onto a marking, so that a session of few frames at each place has such frames too.
    /// The first frame is so long after the drift has begun.
    /// </summary>
    private const double SecondsToMarking = 1.5;

    /// <summary>After so long the ego need not drift: it may wait at a light or follow a lane too narrow for it.</summary>
    private const double MaxSecondsToDrift = 25;

    private readonly List<Vehicle> _vehicles;
    private readonly List<Walker> _walkers;

    /// <summary>The walkers, and the people who were put into the world.</summary>
    private readonly List<IPerson> _people;
    private readonly TrafficFlow _traffic;
    private readonly WalkerFlow _walking;
    private readonly SignalProps _signalProps;
    private readonly WorldContents _contents;
    private readonly MotionMeter _motion;
    private readonly Func<EgoWatch> _newWatch;
    private readonly ReplayedTraffic? _replayed;
    private readonly int _lastHandleInTraffic;
    private readonly Lazy<GroundPlan> _ground;

    public SimulatedWorld(SimulationOptions options)
        : this(options, new HandleCounter(), 0, 0) { }

    /// <summary>The world around one of the places that a game visits.</summary>
    /// <param name="options">The options, with the place as start.</param>
    /// <param name="handles">Gives handles that no world of the game has used.</param>
    /// <param name="place">Number of the place: each has its own traffic and people.</param>
    /// <param name="timeSeconds">The game's time, seconds.</param>
    /// <exception cref="ArgumentException">No road or no lane lies there.</exception>
    public SimulatedWorld(SimulationOptions options, HandleCounter handles, int place, double timeSeconds)
    {
        TimeSeconds = timeSeconds;
        int seed = (options.TrafficSeed ?? options.Seed) ^ (place * SeedStep);
        Vector3D start =
            options.Near is { } near ? new Vector3D(near.X, near.Y, 0)
            : options.Roads is { } roads ? Middle(roads)
            : Vector3D.Zero;
        RoadStyle style = new(options.HasVariedRoads, options.PaintWear);
        Site site = options.Roads is null
            ? SiteCache.Shared.Town(options.Seed, style)
            : SiteCache.Shared.Roads(options.Seed, options.Roads, start, options.RadiusMetres, style);
        if (!site.Network.Nodes.Any(node => Horizontal.Distance(node.Position, start) < options.RadiusMetres))
        {
            throw new ArgumentException(
                FormattableString.Invariant($"No road lies within {options.RadiusMetres} m of {start.X}, {start.Y}; choose another place.")
            );
        }

        Roads = site.Network;
        Truth = new RoadTruth(site.Index);
        Paint = site.Paint;
        Marks = site.Marks;
        _ground = site.GroundPlan;
        ModelCatalogue catalogue = ModelCatalogue.Shared;
        Population population = new(seed, catalogue, handles);
        Placing placing = new(site.Lanes, seed);
        bool isWarm = options.IsWarm && options.Stage is null && options.Replay is null;
        int? visit = isWarm ? place : null;
        (LanePath Path, double Distance) startOfEgo =
            options.Stage is { } setting ? StageStart.Of(site.Lanes, setting)
            : options.StartSeed is { } startSeed ? placing.RandomStartOfEgo(startSeed)
            : placing.StartOfEgo(start, visit);
        Vector3D? busy = isWarm ? startOfEgo.Path.Line.PositionAt(startOfEgo.Distance) : null;
        double parkedDensity = options.ParkedDensity ?? options.TrafficDensity;
        List<Prop> parked = population.Park(site.Walkways, site.Index, busy, parkedDensity);
        if (busy is { } visited)
        {
            parked.AddRange(population.Leave(site.Plan.Roads, site.Index, visited, site.Terrain.HeightAt, parkedDensity));
        }

        parked.RemoveAll(prop => options.Stage?.IsKeptClear(prop.Pose.Position) ?? false);

        _vehicles = population.Drive(placing, parked, startOfEgo, visit, options.TrafficDensity);
        _walkers = population.Walk(site.Walkways, busy, options.PedestrianDensity);
        _people = [.. _walkers];
        _lastHandleInTraffic = _vehicles[^1].Handle;
        bool isLively = options.Wander > 0 || options.LaneChanges > 0;
        Car = new EgoCar(
            Ego,
            site.Lanes,
            isLively ? new EgoManoeuvres(Ego, new LaneTravel(site.Lanes), seed, options.Wander, options.LaneChanges) : null
        );
        if (isLively)
        {
            Car.Loosen();
        }

        _motion = new MotionMeter(Ego, Car);
        _walking = new WalkerFlow(_walkers, site.Walkways);

        Scenery scenery = new(options.Seed, site, catalogue, handles);
        scenery.AddAlong(site.Walkways);
        new Countryside(options.Seed, site, scenery).AddAlong(site.Plan);
        _signalProps = new SignalProps(site.Signals, handles);
        if (options.Props is null)
        {
            scenery.AddLamps(site.Plan, site.Walkways);
            _signalProps.AddAtStopLines(site.Index, catalogue);
            scenery.AddStopSigns(site.Plan, site.Signals.Has);
        }
        else
        {
            PropPlacement[] props = [.. options.Props.Where(prop => Horizontal.Distance(prop.Position, start) < options.RadiusMetres)];
            scenery.AddLamps(props.Where(prop => prop.Name.StartsWith("prop_streetlight", StringComparison.Ordinal)));
            _signalProps.AddGiven(props.Where(prop => prop.Name.StartsWith("prop_traffic", StringComparison.Ordinal)), catalogue);
        }

        foreach (Vehicle ridden in _vehicles.Where(vehicle => vehicle.Rider is not null))
        {
            ridden.RiderHandle = handles.Next();
        }

        LaneControl control = new(site.Signals, scenery.StopArms);
        IEnumerable<Footprint> obstacles = parked.Select(prop => Footprint.Of(prop.Pose, prop.Model.Min, prop.Model.Max));
        List<ParkedVehicle> loose = options.HasCrashes ? [.. parked.Select(prop => new ParkedVehicle(prop))] : [];
        CrashFlow? crashes = options.HasCrashes ? new CrashFlow(site.Lanes, _vehicles, loose, _people) : null;
        _traffic = new TrafficFlow(site.Lanes, control, _vehicles, Car, obstacles, placing, crashes)
        {
            Radius = options.TrafficRadiusMetres,
        };
        _newWatch = () => new EgoWatch(Ego, Car, _traffic, _people, control);
        List<Prop> still = options.HasCrashes ? [] : parked;
        Scene = new RenderScene([
            .. site.Ground,
            .. still.Concat(scenery.Props).Select(prop => new MeshInstance(prop.Model.Variant(prop.Variant), prop.Pose, prop.Handle)),
            .. _walkers.Select(walker => walker.Bench).OfType<Pose>().Select(bench => new MeshInstance(catalogue.Bench.Mesh, bench, 0)),
        ]);
        SetRain(Weather.LightingOf(options.Weather, options.DayOfYear, options.TimeOfDay).RainFraction);
        if (options.Stage is { } stage)
        {
            TimeSeconds += StageStart.SecondsToGreen(stage, startOfEgo, control, TimeSeconds);
            Stage = new WorldStage(stage, catalogue, handles, new StagedGround(site.Lanes, site.Terrain.HeightAt), _traffic, _walking);
            Stage.Enter(_vehicles, _people, () => Advance(MaxTick));
        }

        if (options.Replay is { } replay)
        {
            _replayed = new ReplayedTraffic(replay, catalogue, handles.Next, new StagedGround(site.Lanes, site.Terrain.HeightAt));
            _replayed.MoveTo(TimeSeconds, 0, Ego);
        }

        Prop[] fixtures = [.. still, .. scenery.Props.Where(prop => prop.Handle != 0)];
        _contents = new WorldContents(_vehicles, _people, loose, fixtures, _signalProps, scenery.Lamps, _replayed);
        if (isWarm)
        {
            const double minSeconds = 5;
            const double moreSeconds = 10;
            BuildTrees();
            Advance(minSeconds + (moreSeconds * new Random(seed).NextDouble()));
            if (place % 2 == 1)
            {
                Car.Prompt(place % 4 == 1 ? -1 : 1);
                for (double waited = 0; Car.IsPrompted && waited < MaxSecondsToDrift; waited += MaxTick)
                {
                    Advance(MaxTick);
                }

                Advance(SecondsToMarking);
            }
        }
    }

    public RoadNetwork Roads { get; }

    public RoadTruth Truth { get; }

    public RenderScene Scene { get; }

    /// <summary>The lines painted along the roads.</summary>
    public IReadOnlyList<PaintedLine> Paint { get; }

    /// <summary>The stop lines and pedestrian crossings.</summary>
    public IReadOnlyList<PaintedMark> Marks { get; }

    /// <summary>The ground as faces.</summary>
    public GroundPlan Ground => _ground.Value;

    /// <summary>Puts actors into the world; null unless the options set a stage.</summary>
    public WorldStage? Stage { get; }

    /// <summary>Seconds since the start.</summary>
    public double TimeSeconds { get; private set; }

    public Vehicle Ego => _vehicles[0];

    /// <summary>The ego as a driven car.</summary>
    public EgoCar Car { get; }

    public EgoState EgoState =>
        new(Ego.Handle, Ego.Model.Name, Ego.Pose, Ego.Velocity)
        {
            ModelMin = Ego.Model.Min,
            ModelMax = Ego.Model.Max,

            // The wheels stand on the ground, at the lower end of the model's box.
            HeightAboveGroundMetres = -Ego.Model.Min.Z / Ego.Pose.Axes.Up.Z,
            Motion = _motion.Motion,
        };

    /// <summary>Whether the ego is on its way through a junction or has to stop at a line ahead.</summary>
    public bool NeedsOwnDriver => Ego.Path.Junction is not null || _traffic.MustEgoGiveWay;

    public IReadOnlyList<Vehicle> Vehicles => _vehicles;

    /// <inheritdoc cref="WorldContents.HiddenHandle"/>
    public int HiddenHandle
    {
        get => _contents.HiddenHandle;
        set => _contents.HiddenHandle = value;
    }

    /// <inheritdoc cref="WorldContents.IsDark"/>
    public bool IsDark
    {
        get => _contents.IsDark;
        set => _contents.IsDark = value;
    }

    /// <summary>Whether a handle is that of a vehicle in traffic or of the ego.</summary>
    public bool IsVehicle(int handle) => handle >= _vehicles[0].Handle && handle <= _lastHandleInTraffic;

    /// <summary>Places the ego at a position, at rest.</summary>
    public void ResetEgo(Vector3D position, double headingDegrees) => _traffic.ResetEgo(position, headingDegrees);

    /// <summary>How the ego has driven since the first call.</summary>
    public EgoConduct Conduct => (_traffic.Watch ??= _newWatch()).At(TimeSeconds);

    /// <summary>The overridden traffic lights by handle.</summary>
    public Dictionary<int, SignalState> DrivenLights => _signalProps.Driven;

    /// <summary>The state of a traffic light at a time; null for another entity.</summary>
    public LightState? LightAt(int handle, double timeSeconds) => _signalProps.StateAt(handle, timeSeconds)?.AsLight();

    /// <summary>The impacts of the last call of <see cref="Advance"/>; empty in a world without crashes.</summary>
    public IReadOnlyList<Impact> Impacts { get; private set; } = [];

    /// <summary>Sets how wet the road is, from 0, dry, to 1; it has no influence on a world without crashes.</summary>
    public void SetRain(double fraction)
    {
        if (_traffic.Crashes is { } crashes)
        {
            crashes.Grip = RoadGrip.In(fraction);
            Car.SetGrip(crashes.Grip);
        }
    }

    /// <summary>Makes a change of a driver, or removes an entity.</summary>
    /// <exception cref="ArgumentException">There is no such vehicle or person.</exception>
    public void Make(WorldChange change) => new WorldChanges(_vehicles, _walkers, _people, _traffic, Stage).Make(change, TimeSeconds);

    public void Advance(double seconds)
    {
        List<Impact> impacts = [];
        int steps = (int)Math.Ceiling(seconds / MaxTick);
        for (int i = 0; i < steps; i++)
        {
            double step = seconds / steps;
            _motion.Begin();
            if (_replayed is { } replayed)
            {
                replayed.MoveTo(TimeSeconds + step, step, Ego);
            }
            else
            {
                _traffic.Tick(step, TimeSeconds, _walking.OnRoad());
                impacts.AddRange(_traffic.Crashes?.Impacts ?? []);
                _walking.Tick(step, _traffic, Ego.Pose.Position, _traffic.Radius);
                Stage?.TickPeople(step);
            }

            _motion.End(step);
            TimeSeconds += step;
        }

        Impacts = impacts;
        Car.EndTick();
    }

    /// <inheritdoc cref="WorldContents.MovingNear"/>
    public IEnumerable<MeshInstance> MovingNear(Vector3D place, double range) => _contents.MovingNear(place, range, TimeSeconds);

    /// <inheritdoc cref="WorldContents.EntitiesNear"/>
    public List<EntityState> EntitiesNear(Vector3D place, double range) => _contents.EntitiesNear(place, range, TimeSeconds);

    /// <inheritdoc cref="WorldContents.VehicleNearest"/>
    public int VehicleNearest(Vector3D place) => _contents.VehicleNearest(place);

    /// <inheritdoc cref="WorldContents.LightsNear"/>
    public List<LightSource> LightsNear(Vector3D eye) => _contents.LightsNear(eye);

    /// <summary>
    /// Begins to build, on another thread, the trees of the meshes around the ego: the first pictures need them, and the traffic, which is
    /// simulated meanwhile, does not. A mesh whose tree is not ready in time builds it where it is needed.
    /// </summary>
    private void BuildTrees()
    {
        const double reachMetres = 150;
        Vector3D place = Ego.Pose.Position;
        Mesh[] nearest =
        [
            .. Scene
                .Static.Instances.ToArray()
                .Concat(MovingNear(place, reachMetres))
                .Select(instance => (instance.Mesh, Distance: instance.Mesh.Bounds.MovedBy(instance.Pose).DistanceTo(place)))
                .Where(each => each.Distance < reachMetres)
                .OrderBy(each => each.Distance)
                .Select(each => each.Mesh)
                .Distinct(),
        ];
        _ = Task.Run(() => Array.ForEach(nearest, static mesh => _ = mesh.Tree));
    }

    private static Vector3D Middle(RoadNetwork network) =>
        network.Nodes.Aggregate(Vector3D.Zero, (sum, node) => sum + node.Position) / network.Nodes.Count;
}
