using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Moves vehicles along their lanes. A vehicle never moves into another one, whatever its driver has decided.</summary>
internal sealed class TrafficFlow
{
    /// <summary>Minimum distance between two bodies, metres.</summary>
    public const double Clearance = 0.15;

    /// <summary>Way beyond its next step that must be free before a vehicle moves, metres.</summary>
    private const double LookAhead = 1;

    /// <summary>Of an ego that is held by its brakes, also on a steep road, m/s².</summary>
    private const double HoldingAcceleration = -4;

    /// <summary>A vehicle that has stood for this long is placed elsewhere: longer than a cycle of the lights, seconds.</summary>
    private const double StuckSeconds = 40;

    /// <summary>If the ego has stood for this long, those who stand as long within these metres of it are placed elsewhere.</summary>
    private const double EgoPatienceSeconds = 12;
    private const double EgoSurroundings = 30;

    private readonly RightOfWay _rightOfWay;
    private readonly Placing _placing;
    private readonly IReadOnlyList<Vehicle> _vehicles;
    private readonly BodyIndex<Vehicle> _index = new();
    private readonly BodyIndex<Footprint> _obstacles = new();
    private readonly LaneOccupation _occupation;
    private readonly EgoCar _egoCar;
    private readonly HardBraking? _hardBraking;

    /// <summary>
    /// Starts with vehicles that are on lanes and clear of each other and of obstacles; the first is the ego. Without crashes, a vehicle
    /// stops at once before it moves into another.
    /// </summary>
    public TrafficFlow(
        LaneGraph lanes,
        LaneControl control,
        IReadOnlyList<Vehicle> vehicles,
        EgoCar egoCar,
        IEnumerable<Footprint> obstacles,
        Placing placing,
        CrashFlow? crashes = null
    )
    {
        Crashes = crashes;
        _vehicles = vehicles;
        _egoCar = egoCar;
        _placing = placing;
        _occupation = new LaneOccupation(lanes);
        _rightOfWay = new RightOfWay(lanes, control, _occupation);
        foreach (Vehicle vehicle in vehicles)
        {
            _index.Add(vehicle, vehicle.Pose.Position);
        }

        foreach (Footprint obstacle in obstacles)
        {
            _obstacles.Add(obstacle, obstacle.Centre);
        }

        if (crashes is not null)
        {
            _hardBraking = new HardBraking(_index, _obstacles);
            crashes.HasPushed = (before, after) =>
            {
                _obstacles.Remove(before, before.Centre);
                _obstacles.Add(after, after.Centre);
            };
        }
    }

    /// <summary>Lets vehicles collide; null in a world without crashes.</summary>
    public CrashFlow? Crashes { get; }

    /// <summary>Whether the ego has to stop at a line ahead.</summary>
    public bool MustEgoGiveWay { get; private set; }

    /// <summary>Vehicles farther than this from the ego do not move, metres; null to move all.</summary>
    public double? Radius { get; init; }

    /// <summary>Watches how the ego drives; null for nobody.</summary>
    public EgoWatch? Watch { get; set; }

    /// <summary>How often the ego was repositioned, at a dead end or when stuck.</summary>
    public int EgoReplacements { get; private set; }

    private Vehicle Ego => _vehicles[0];

    /// <summary>Whether a condition on a vehicle and a position holds for one of the vehicles near the position.</summary>
    public bool AnyNear(Vector3D place, Func<Vehicle, Vector3D, bool> condition) => _index.AnyNear(place, place, condition);

    /// <summary>Places the ego at a position, at rest.</summary>
    public void ResetEgo(Vector3D position, double headingDegrees)
    {
        Vector3D before = Ego.Pose.Position;
        _rightOfWay.ReleaseAll(Ego);
        _egoCar.Reset(position, headingDegrees);
        _index.Move(Ego, before, Ego.Pose.Position);
        Watch?.Jump();
    }

    /// <summary>Moves staged vehicles; null in a world without any.</summary>
    public StagedTraffic? Staged { get; private set; }

    /// <summary>Whether the ego stands still, whatever its driver wants, until a stage is set.</summary>
    public bool HoldsEgo { get; set; }

    /// <summary>Lets vehicles be staged.</summary>
    /// <param name="ground">The ground under them.</param>
    public StagedTraffic Stage(StagedGround ground) => Staged ??= new StagedTraffic(_index, _obstacles, ground, Crashes is not null);

    /// <summary>Takes note of a vehicle that came into the world.</summary>
    public void Enter(Vehicle vehicle) => _index.Add(vehicle, vehicle.Pose.Position);

    /// <summary>Forgets a vehicle that was taken out of the world.</summary>
    public void Leave(Vehicle vehicle)
    {
        _rightOfWay.ReleaseAll(vehicle);
        _index.Remove(vehicle, vehicle.Pose.Position);
    }

    /// <summary>Whether a body would meet another one, a person excepted.</summary>
    public bool IsTaken(Footprint place) =>
        _index.Near(place.Centre).Any(other => place.Overlaps(other.Footprint)) || _obstacles.Near(place.Centre).Any(place.Overlaps);

    /// <summary>Whether the ego touches another vehicle.</summary>
    public bool TouchesVehicle() =>
        _index.AnyNear(Ego.Pose.Position, Ego, static (other, ego) => other != ego && ego.Footprint.Overlaps(other.Footprint));

    /// <summary>Whether the ego touches something that stands beside the road, such as a parked vehicle.</summary>
    public bool TouchesObstacle() => _obstacles.AnyNear(Ego.Pose.Position, Ego, static (other, ego) => ego.Footprint.Overlaps(other));

    public void Tick(double seconds, double timeSeconds, BodyIndex<IPerson> walkersOnRoad)
    {
        _occupation.Refresh(_vehicles);
        Crashes?.Begin();
        foreach (Vehicle vehicle in _vehicles)
        {
            if (Radius is { } radius && Horizontal.SquaredDistance(vehicle.Pose.Position, Ego.Pose.Position) > radius * radius)
            {
                continue;
            }

            if (vehicle.Wreck is not null && !Recovers(vehicle))
            {
                Rest(vehicle, seconds);
                continue;
            }

            if (vehicle.Staged is { } motion)
            {
                Staged!.Move(vehicle, motion, seconds, walkersOnRoad);
                continue;
            }

            if (vehicle == Ego && HoldsEgo)
            {
                continue;
            }

            double distanceToStop = _rightOfWay.DistanceToStop(vehicle, timeSeconds);
            double acceleration = Driver.Acceleration(vehicle, _occupation, distanceToStop, walkersOnRoad);
            acceleration = vehicle.Ordered?.Limit(acceleration, timeSeconds) ?? acceleration;
            acceleration = Limited(vehicle, acceleration, seconds, walkersOnRoad);
            Vector3D before = vehicle.Pose.Position;
            MustEgoGiveWay = vehicle == Ego ? distanceToStop < double.PositiveInfinity : MustEgoGiveWay;
            if (vehicle == Ego && _egoCar.IsLoose)
            {
                _egoCar.Decide(seconds, _occupation, place => IsTaken(vehicle, place));
                if (Crashes is null && !_egoCar.IsDriven && IsEgoBlocked(acceleration, seconds, walkersOnRoad))
                {
                    _egoCar.Stop();
                    acceleration = Math.Min(acceleration, HoldingAcceleration);
                }

                _egoCar.Advance(seconds, acceleration, room => Crashes is null && IsTaken(vehicle, vehicle.Footprint.Grown(room)));
            }
            else
            {
                Advance(vehicle, acceleration, seconds, walkersOnRoad);
            }

            if (HasToLeave(vehicle))
            {
                Replace(vehicle);
            }

            vehicle.Signals.Tick(vehicle.Speed, seconds);
            _rightOfWay.ReleasePassed(vehicle);
            _index.Move(vehicle, before, vehicle.Pose.Position);
        }

        Collide(seconds, timeSeconds + seconds);
        Watch?.Tick(timeSeconds + seconds);
    }

    /// <summary>
    /// The acceleration of a vehicle that may crash: at most what its tyres allow, and all of that when something is in its way. A vehicle
    /// that cannot crash stops at once instead.
    /// </summary>
    private double Limited(Vehicle vehicle, double wanted, double seconds, BodyIndex<IPerson> walkersOnRoad)
    {
        if (Crashes is null)
        {
            return wanted;
        }

        double most = Crashes.Grip.Braking;
        (double metres, _) = Step(vehicle, wanted, seconds);
        bool mustBrake =
            (metres > 0 && !vehicle.IsBlindToStaged && !IsFree(vehicle, metres, walkersOnRoad))
            || (vehicle == Ego && _egoCar.IsLoose && !vehicle.IsBlindToStaged && MeetsWalker(vehicle, walkersOnRoad))
            || _hardBraking!.IsNeeded(vehicle, most, walkersOnRoad);
        return mustBrake ? -most : Math.Max(wanted, -most);
    }

    /// <summary>Whether a wreck drives again: the ego can, once it has come to rest and a program drives it.</summary>
    private bool Recovers(Vehicle vehicle)
    {
        if (vehicle != Ego || !_egoCar.IsDriven || !vehicle.Wreck!.IsAtRest)
        {
            return false;
        }

        vehicle.Wreck = null;
        _egoCar.Loosen();
        return true;
    }

    private void Rest(Vehicle vehicle, double seconds)
    {
        vehicle.StandingSeconds = vehicle.Wreck!.IsAtRest ? vehicle.StandingSeconds + seconds : 0;
        vehicle.Signals.Tick(vehicle.Speed, seconds);
        if (vehicle == Ego)
        {
            _egoCar.Slide();
            if (HasToLeave(vehicle))
            {
                Vector3D before = vehicle.Pose.Position;
                Replace(vehicle);
                _index.Move(vehicle, before, vehicle.Pose.Position);
            }
        }
    }

    private void Collide(double seconds, double timeSeconds)
    {
        if (Crashes is null)
        {
            return;
        }

        Dictionary<Vehicle, Vector3D> before = [];
        foreach (Vehicle vehicle in Crashes.End(seconds, timeSeconds, _index, before))
        {
            _rightOfWay.ReleaseAll(vehicle);
            _index.Move(vehicle, before[vehicle], vehicle.Pose.Position);
            if (vehicle == Ego)
            {
                _egoCar.Slide();
            }
        }
    }

    private void Advance(Vehicle vehicle, double acceleration, double seconds, BodyIndex<IPerson> walkersOnRoad)
    {
        (double metres, double speed) = Step(vehicle, acceleration, seconds);
        if (metres > 0 && (Crashes is not null || IsFree(vehicle, metres, walkersOnRoad)))
        {
            vehicle.Advance(metres);
            vehicle.Speed = speed;
            vehicle.StandingSeconds = 0;
        }
        else
        {
            vehicle.Speed = 0;
            vehicle.StandingSeconds += seconds;
        }
    }

    private bool IsEgoBlocked(double acceleration, double seconds, BodyIndex<IPerson> walkersOnRoad)
    {
        (double metres, _) = Step(Ego, acceleration, seconds);
        return metres > 0 && (!IsFree(Ego, metres, walkersOnRoad) || MeetsWalker(Ego, walkersOnRoad));
    }

    private static (double Metres, double Speed) Step(Vehicle vehicle, double acceleration, double seconds)
    {
        // Constant acceleration within the step: way = (v + v') / 2 · t.
        double speed = Math.Max(0, vehicle.Speed + (acceleration * seconds));
        return ((vehicle.Speed + speed) / 2 * seconds, speed);
    }

    private void Replace(Vehicle vehicle)
    {
        _rightOfWay.ReleaseAll(vehicle);
        EgoReplacements += _placing.Replace(vehicle, place => !IsTaken(vehicle, place)) && vehicle == Ego ? 1 : 0;
        if (vehicle == Ego && _egoCar.IsLoose)
        {
            _egoCar.Loosen();
        }
    }

    private bool HasToLeave(Vehicle vehicle)
    {
        const double nearlyAtEnd = 2;
        bool atDeadEnd = !vehicle.CanGoOn && vehicle.Distance + vehicle.FrontOverhang > vehicle.Path.Length - nearlyAtEnd;
        bool isInTheWay =
            vehicle != Ego
            && Ego.StandingSeconds > EgoPatienceSeconds
            && (vehicle.StandingSeconds > EgoPatienceSeconds || vehicle.GoesInCircles)
            && (vehicle.Pose.Position - Ego.Pose.Position).Length < EgoSurroundings;
        bool isStuck = vehicle.StandingSeconds > StuckSeconds && !(vehicle == Ego && _egoCar.IsDriven);
        return atDeadEnd || isInTheWay || isStuck;
    }

    private bool IsFree(Vehicle vehicle, double metres, BodyIndex<IPerson> walkersOnRoad)
    {
        Footprint now = vehicle.Footprint;
        var way = new WayAhead(
            vehicle,
            now,
            vehicle.FootprintAhead(metres).Grown(Clearance),
            vehicle.FootprintAhead(metres + LookAhead).Grown(Clearance)
        );
        return !_index.AnyNear(now.Centre, way, static (other, way) => other != way.Vehicle && way.IsBlockedBy(other.Footprint))
            && !_obstacles.AnyNear(now.Centre, way, static (other, way) => way.IsBlockedBy(other))
            && !walkersOnRoad.AnyNear(now.Centre, way, static (walker, way) => way.IsBlockedBy(walker.Footprint));
    }

    /// <summary>Whether somebody walks just ahead of a vehicle that need not be on its lane's line.</summary>
    private static bool MeetsWalker(Vehicle vehicle, BodyIndex<IPerson> walkersOnRoad)
    {
        Footprint now = vehicle.Footprint.Grown(Clearance);
        Footprint ahead = now with { Centre = now.Centre + (now.Forward * LookAhead) };
        return walkersOnRoad.AnyNear(now.Centre, ahead, static (walker, ahead) => ahead.Overlaps(walker.Footprint));
    }

    private bool IsTaken(Vehicle vehicle, Footprint place) =>
        _index.Near(place.Centre).Any(other => other != vehicle && place.Overlaps(other.Footprint))
        || _obstacles.Near(place.Centre).Any(place.Overlaps);
}
