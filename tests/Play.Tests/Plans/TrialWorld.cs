using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Play.Features;
using Harvester.Play.Plans;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Plans;

/// <summary>
/// A game for trials: one car, which drives east at 10 m/s when it is driven, ground at 30 m, and a harvest that takes a frame in every
/// tenth tick. A tick has 50 ms. Each thing that may go wrong is a property.
/// </summary>
internal sealed class TrialWorld : ITrialGame, ICarControls, IVehicles, IModels, IDrivenCar, IWorld, IScreen, ITrialHarvest
{
    public const int Car = 7;
    public const double GroundMetres = 30;
    private const double TickMilliseconds = 50;
    private const double MetresPerTick = 0.5;
    private const int TicksPerFrame = 10;
    private readonly TestClock _clock = new();
    private int _ticksOfHarvest;
    private int _maxFrames;
    private bool _isDriven;

    public TrialSurroundings Surroundings =>
        _surroundings ??= new TrialSurroundings
        {
            Game = this,
            Grip = new TrialGrip(this, this),
            Controls = this,
            Car = new TrialCar(this, this, this, 1),
            Driven = this,
            World = this,
            Roads = new FakeRoadSource(new RoadNetwork([], [])),
            Settling = new PictureSettling(this, _clock),
            Stage = new TrialStage(
                Staged,
                place => NetworkOfStage is { } network ? new FixedRoads(network, "test").Near(place) : null,
                RoadGeometry.LaneWidth,
                RoadGeometry.NarrowLaneWidth
            ),
            Harvest = this,
            Clock = _clock,
            Options = new HarvestOptions { Rig = Rig, Freeze = Freezes },
            Log = Logged.Add,
        };

    private TrialSurroundings? _surroundings;

    /// <summary>The actors of scenarios.</summary>
    public FakeTrialStage Staged => _staged ??= new FakeTrialStage(isDriven => _isDriven = isDriven);

    private FakeTrialStage? _staged;

    /// <summary>The roads on which scenarios are staged; null while they are not known.</summary>
    public RoadNetwork? NetworkOfStage { get; set; }

    /// <summary>What the last session keeps of its scenario.</summary>
    public KeptScenario? KeptOfScenario { get; private set; }

    /// <summary>The measured pace of harvests.</summary>
    public double? RealSecondsPerGameSecond { get; set; }

    /// <summary>The rig of the settings.</summary>
    public Rig? Rig { get; set; }

    /// <summary>Whether the settings freeze the world for a frame.</summary>
    public bool Freezes { get; set; } = true;

    public List<string> Logged { get; } = [];

    /// <summary>What was done to the game, in order.</summary>
    public List<string> Done { get; } = [];

    /// <summary>The vehicles that were repaired, in order.</summary>
    public List<int> Repaired { get; } = [];

    public (double Steering, double Throttle, double Brake, double Handbrake) InForce => default;

    public GameSituation Situation { get; set; } = new() { IsInVehicle = true };

    /// <summary>Corrects the situation as the game would.</summary>
    public bool AcceptsCorrections { get; set; } = true;

    public int PlayersVehicle { get; set; } = Car;

    public HashSet<int> Vehicles { get; } = [Car];

    public bool IsSceneLoaded { get; set; } = true;

    public bool IsCollisionLoaded { get; set; } = true;

    public double? Ground { get; set; } = GroundMetres;

    /// <summary>Whether the picture changes from look to look.</summary>
    public bool IsPictureRestless { get; set; }

    public bool Moves { get; set; } = true;

    public Vector3D Position { get; private set; }

    public double HeadingDegrees { get; private set; }

    public string? Weather { get; private set; }

    public TimeSpan TimeOfDay { get; private set; }

    public (double Traffic, double Pedestrians, double Parked)? Densities { get; private set; }

    public bool IsHeld { get; private set; }

    public bool IsProtected { get; private set; }

    public bool IsLoading { get; private set; }

    public bool IsDriving => _isDriven;

    public HarvestOptions? HarvestedWith { get; private set; }

    public bool IsOn { get; private set; }

    public bool IsBusy { get; set; }

    public int Captured { get; private set; }

    public string? Fault { get; set; }

    /// <summary>Whether setting the time of day fails.</summary>
    public bool RefusesTime { get; set; }

    public bool IsSpaceLow { get; set; }

    public bool BeginsHarvests { get; set; } = true;

    public int OfPlayer => PlayersVehicle;

    public long GameFrame { get; private set; }

    public double TimeSeconds => _clock.Milliseconds / 1000;

    public bool ArePlayers => false;

    public bool IsTakenByPlayer => false;

    public double Milliseconds => _clock.Milliseconds;

    /// <summary>Lets a tick of the game go by.</summary>
    public void Pass()
    {
        _clock.Milliseconds += TickMilliseconds;
        GameFrame++;
        Position += _isDriven && Moves && !IsHeld ? new Vector3D(MetresPerTick, 0, 0) : Vector3D.Zero;
        _ticksOfHarvest += IsOn ? 1 : 0;
        Captured = IsOn ? Math.Min(_maxFrames, _ticksOfHarvest / TicksPerFrame) : Captured;
        IsOn = IsOn && Captured < _maxFrames;
    }

    public GameSituation Read(int vehicle) => Situation with { Position = Position };

    public void Protect(int vehicle) => IsProtected = true;

    public void Unprotect(int vehicle) => IsProtected = false;

    public void ClearWanted()
    {
        Done.Add("clear wanted");
        Situation = AcceptsCorrections ? Situation with { WantedLevel = 0 } : Situation;
    }

    public void EndCutScene()
    {
        Done.Add("end cut scene");
        Situation = AcceptsCorrections ? Situation with { IsInCutScene = false } : Situation;
    }

    public void EnterVehicle(int vehicle)
    {
        Done.Add($"seat in {vehicle}");
        PlayersVehicle = vehicle;
        Situation = Situation with { IsInVehicle = true };
    }

    public void Repair(int vehicle) => Repaired.Add(vehicle);

    public void BeginLoading(Vector3D place) => IsLoading = true;

    public void EndLoading() => IsLoading = false;

    public void RequestCollision(Vector3D place) { }

    public bool HasCollision(int vehicle) => IsCollisionLoaded;

    public double? GroundBelow(Vector3D place) => Ground;

    public void Hold(int vehicle, Vector3D? place)
    {
        IsHeld = place is not null;
        Position = place ?? Position;
    }

    public void SetDensities(double traffic, double pedestrians, double parked) => Densities = (traffic, pedestrians, parked);

    public void DriveAlongRoads(int vehicle, double speedMetresPerSecond) => _isDriven = true;

    public void StopDriving() => _isDriven = false;

    public void Set(double steering, double throttle, double brake, bool handbrake) => throw new NotSupportedException();

    public void Place(int vehicle, Vector3D position, double headingDegrees)
    {
        (Position, HeadingDegrees) = (position, headingDegrees);
        Situation = Situation with { IsInWater = false, IsUpsideDown = false };
    }

    public void KeepWeather(string? weather) => Weather = weather;

    public void SetTimeOfDay(TimeSpan timeOfDay) => TimeOfDay = RefusesTime ? throw new InvalidOperationException("No.") : timeOfDay;

    public bool Exists(int vehicle) => Vehicles.Contains(vehicle);

    public int MakeBesidePlayer(int model, double metresBeside)
    {
        Vehicles.Add(Car + 1);
        return Car + 1;
    }

    public void Prepare(int vehicle, int primaryColour, int secondaryColour, string plate) => Done.Add($"prepare {vehicle}");

    public void Remove(int vehicle) => Vehicles.Remove(vehicle);

    public bool IsVehicle(int model) => true;

    public bool Load(int model) => true;

    public void Release(int model) { }

    public (Vector3D Min, Vector3D Max) DimensionsOf(int model) => throw new NotSupportedException();

    public int VehicleClassOf(int vehicle) => throw new NotSupportedException();

    public string DisplayNameOf(int model) => throw new NotSupportedException();

    public void Drive(DrivingControls controls) => _isDriven = controls.Throttle > 0;

    public void Reset(Vector3D position, double headingDegrees) => throw new NotSupportedException();

    public void SetEnvironment(string? weather, TimeSpan? timeOfDay) => throw new NotSupportedException();

    public CameraState ReadCamera() => throw new NotSupportedException();

    public EgoState ReadEgo() => new(Car, "adder", new Pose(Position, Axes.FromHeading(HeadingDegrees)), Vector3D.Zero);

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range) => [];

    public EnvironmentState ReadEnvironment() => new(Weather ?? "clear", TimeOfDay);

    public GrabResult Grab(PixelBuffer target)
    {
        Array.Fill(target.Bytes, IsPictureRestless ? (byte)(GameFrame * 7) : (byte)50);
        return GrabResult.Good;
    }

    public bool Begin(string folder, HarvestOptions options, double verticalFovDegrees, KeptScenario? scenario = null)
    {
        if (BeginsHarvests)
        {
            KeptOfScenario = scenario;
            Directory.CreateDirectory(folder);
            (IsOn, HarvestedWith, _ticksOfHarvest, Captured, _maxFrames) = (true, options, 0, 0, options.MaxFrames!.Value);
        }

        return BeginsHarvests;
    }

    public void End() => IsOn = false;

    /// <summary>Ends the harvest as a fault would.</summary>
    public void Break(string fault) => (IsOn, Fault) = (false, fault);
}
