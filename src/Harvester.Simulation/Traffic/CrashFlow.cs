using Harvester.Geometry;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// Lets bodies collide: after vehicles have moved as their drivers want, those that touch exchange impulses and become wrecks, and people who
/// are struck are thrown.
/// </summary>
/// <param name="lanes">The lanes, which are the ground.</param>
/// <param name="vehicles">All vehicles; the first is the ego.</param>
/// <param name="parked">The parked vehicles.</param>
/// <param name="people">The people on foot.</param>
internal sealed class CrashFlow(
    LaneGraph lanes,
    IReadOnlyList<Vehicle> vehicles,
    IReadOnlyList<ParkedVehicle> parked,
    IReadOnlyList<IPerson> people
)
{
    /// <summary>A person who walks against a slower vehicle is not thrown, m/s.</summary>
    private const double MinSpeedAgainstPerson = 0.5;

    /// <summary>A way longer than that at its speed by this, metres, is a vehicle that was placed elsewhere.</summary>
    private const double Displaced = 1;

    private readonly GroundBelow _ground = new(lanes);
    private readonly Dictionary<Vehicle, Footprint> _before = [];
    private readonly BodyIndex<ParkedVehicle> _parked = IndexOf(parked);
    private readonly double[] _egoStruckAt = [double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity];
    private List<Impact> _impacts = [];
    private double _timeSeconds;

    /// <summary>The impacts of the last step, in their order.</summary>
    public IReadOnlyList<Impact> Impacts => _impacts;

    /// <summary>What tyres can do on the road as it is.</summary>
    public RoadGrip Grip { get; set; } = RoadGrip.Dry;

    /// <summary>Called when a parked vehicle is moved: where it stood, and where it stands.</summary>
    public Action<Footprint, Footprint>? HasPushed { get; set; }

    /// <summary>Notes where vehicles are at the beginning of a step.</summary>
    public void Begin()
    {
        _before.Clear();
        foreach (Vehicle vehicle in vehicles)
        {
            _before.Add(vehicle, vehicle.Footprint);
        }
    }

    /// <summary>Moves wrecks, and lets those that touch collide.</summary>
    /// <param name="seconds">Length of the step.</param>
    /// <param name="timeSeconds">The world's time at its end.</param>
    /// <param name="index">All vehicles.</param>
    /// <param name="before">Receives where in the index the vehicles are that were struck or have slid.</param>
    /// <returns>These vehicles.</returns>
    public IReadOnlyList<Vehicle> End(double seconds, double timeSeconds, BodyIndex<Vehicle> index, Dictionary<Vehicle, Vector3D> before)
    {
        _impacts = [];
        SortedDictionary<int, CrashBody> bodies = [];
        foreach (Vehicle vehicle in vehicles)
        {
            Gather(bodies, vehicle, seconds, index);
        }

        foreach (ParkedVehicle vehicle in parked)
        {
            if (vehicle.Wreck is { IsAtRest: false, Body: var body })
            {
                bodies.TryAdd(vehicle.Prop.Handle, BodyOf(vehicle));
                GatherNear(bodies, vehicle.Footprint.Grown(Margin(body.Velocity.Length * seconds)), seconds, index);
            }
        }

        List<Vehicle> moved = [];
        if (bodies.Count > 0)
        {
            _impacts.AddRange(new CrashStep([.. bodies.Values]).Run(seconds, timeSeconds));
            moved = Take(bodies, seconds, before);
        }

        StrikePeople(timeSeconds, moved, before);
        foreach (Impact impact in _impacts.Where(impact => impact.First == Ego.Handle || impact.Second == Ego.Handle))
        {
            _egoStruckAt[(int)KindOf(impact.First == Ego.Handle ? impact.Second : impact.First)] = timeSeconds;
        }

        _timeSeconds = timeSeconds;
        return moved;
    }

    /// <summary>Whether the ego has had an impact of a kind just now; impacts of one collision follow each other within moments.</summary>
    public bool HasStruck(EgoContact kind)
    {
        const double moment = 0.5;
        return _timeSeconds - _egoStruckAt[(int)kind] < moment;
    }

    /// <summary>Height of the ground at a place, metres; the given height where there is no lane.</summary>
    public double GroundAt(Vector3D place, double height) =>
        _ground.Lanes(place) is [var lane, ..] ? lane.Path.Line.PositionAt(lane.Distance).Z : height;

    private Vehicle Ego => vehicles[0];

    private EgoContact KindOf(int handle) =>
        vehicles.Any(vehicle => vehicle.Handle == handle) ? EgoContact.Vehicle
        : parked.Any(vehicle => vehicle.Prop.Handle == handle) ? EgoContact.Parked
        : EgoContact.Pedestrian;

    private static BodyIndex<ParkedVehicle> IndexOf(IReadOnlyList<ParkedVehicle> parked)
    {
        BodyIndex<ParkedVehicle> index = new();
        foreach (ParkedVehicle vehicle in parked)
        {
            index.Add(vehicle, vehicle.Footprint.Centre);
        }

        return index;
    }

    /// <summary>Adds a moving vehicle and those that it may touch in the step to the bodies.</summary>
    private void Gather(SortedDictionary<int, CrashBody> bodies, Vehicle vehicle, double seconds, BodyIndex<Vehicle> index)
    {
        bool slides = vehicle.Wreck is { IsAtRest: false };
        if (!slides && (vehicle.Wreck is not null || vehicle.Speed == 0))
        {
            return;
        }

        double way = Horizontal.Distance(_before[vehicle].Centre, vehicle.Footprint.Centre) + (vehicle.Speed * seconds);
        bool isNear = GatherNear(bodies, vehicle.Footprint.Grown(Margin(way)), seconds, index, vehicle);
        if (isNear || slides)
        {
            Add(bodies, vehicle, seconds);
        }
    }

    /// <summary>Everything within the way of a body and of an equally fast one can touch it.</summary>
    private static double Margin(double way) => (2 * way) + CrashStep.PartMetres;

    private bool GatherNear(
        SortedDictionary<int, CrashBody> bodies,
        Footprint swept,
        double seconds,
        BodyIndex<Vehicle> index,
        Vehicle? without = null
    )
    {
        bool isNear = false;
        foreach (Vehicle other in index.Near(swept.Centre))
        {
            if (other != without && swept.Overlaps(other.Footprint))
            {
                isNear = true;
                Add(bodies, other, seconds);
            }
        }

        foreach (ParkedVehicle other in _parked.Near(swept.Centre))
        {
            if (swept.Overlaps(other.Footprint))
            {
                isNear = true;
                bodies.TryAdd(other.Prop.Handle, BodyOf(other));
            }
        }

        return isNear;
    }

    private void Add(SortedDictionary<int, CrashBody> bodies, Vehicle vehicle, double seconds)
    {
        if (bodies.ContainsKey(vehicle.Handle))
        {
            return;
        }

        if (vehicle.Wreck is { } wreck)
        {
            bodies.Add(vehicle.Handle, new CrashBody(vehicle.Handle, wreck.Body, vehicle.Footprint.Centre.Z, wreck.DecelerationOn(Grip)));
            return;
        }

        Footprint before = _before[vehicle];
        Vector3D moved = vehicle.Footprint.Centre - before.Centre;
        bool wasPlaced = moved.Length > Displaced + (2 * vehicle.Speed * seconds);
        before = wasPlaced ? vehicle.Footprint : before;
        DrivenWay way = new(
            Flat(before.Centre),
            Math.Atan2(before.Forward.Y, before.Forward.X),
            Flat(vehicle.Footprint.Centre),
            Horizontal.Turn(before.Forward, vehicle.Footprint.Forward)
        );
        PlanarBody body = VehicleMass.BodyOf(vehicle.Model, before.HalfLength, before.HalfWidth);
        body.Position = way.From;
        body.Yaw = way.FromYaw;
        body.Velocity = (way.To - way.From) * (1 / seconds);
        body.YawRate = way.Turn / seconds;
        double deceleration = VehicleMass.IsTwoWheeler(vehicle.Model) ? Grip.LyingSlide : Grip.Sliding;
        bodies.Add(vehicle.Handle, new CrashBody(vehicle.Handle, body, vehicle.Footprint.Centre.Z, deceleration) { Way = way });
    }

    private CrashBody BodyOf(ParkedVehicle vehicle)
    {
        PlanarBody body = vehicle.Wreck?.Body ?? BodyAt(vehicle.Prop.Model, vehicle.Footprint);
        double deceleration = VehicleMass.IsTwoWheeler(vehicle.Prop.Model) ? Grip.LyingSlide : Grip.Sliding;
        return new CrashBody(vehicle.Prop.Handle, body, vehicle.Footprint.Centre.Z, deceleration);
    }

    private static PlanarBody BodyAt(Models.Model model, Footprint place)
    {
        PlanarBody body = VehicleMass.BodyOf(model, place.HalfLength, place.HalfWidth);
        body.Position = Flat(place.Centre);
        body.Yaw = Math.Atan2(place.Forward.Y, place.Forward.X);
        return body;
    }

    /// <summary>Moves the vehicles of bodies that nobody drives, and returns those in traffic.</summary>
    private List<Vehicle> Take(SortedDictionary<int, CrashBody> bodies, double seconds, Dictionary<Vehicle, Vector3D> before)
    {
        List<Vehicle> moved = [];
        foreach (Vehicle vehicle in vehicles)
        {
            if (bodies.TryGetValue(vehicle.Handle, out CrashBody? body) && body.Way is null)
            {
                vehicle.Wreck ??= new Wreck(body.Body, vehicle.Model, vehicle.Extents, GroundOf(vehicle.Pose, vehicle.Model));
                vehicle.Wreck.Tick(seconds);
                before.Add(vehicle, vehicle.Pose.Position);
                Put(vehicle);
                moved.Add(vehicle);
            }
        }

        foreach (ParkedVehicle vehicle in parked)
        {
            if (bodies.TryGetValue(vehicle.Prop.Handle, out CrashBody? body) && (body.IsStruck || vehicle.Wreck is not null))
            {
                vehicle.Wreck ??= new Wreck(
                    body.Body,
                    vehicle.Prop.Model,
                    (vehicle.Prop.Model.Min, vehicle.Prop.Model.Max),
                    GroundOf(vehicle.Prop.Pose, vehicle.Prop.Model)
                );
                vehicle.Wreck.Tick(seconds);
                Put(vehicle);
            }
        }

        return moved;
    }

    private void Put(Vehicle vehicle)
    {
        Wreck wreck = vehicle.Wreck!;
        (List<LanePlace> near, double slope) = Settle(wreck);
        Vector3D place = new(wreck.Body.Position.X, wreck.Body.Position.Y, wreck.GroundHeight);
        Vector2D sliding = wreck.Body.Velocity;
        Vector3D velocity = new(sliding.X, sliding.Y, slope * sliding.Dot(wreck.Body.Forward));
        IEnumerable<LanePlace> blocked = near.Where(lane => Math.Abs(lane.RightOffset) < EgoCar.InTheWay);
        if (vehicle.Staged is { } motion)
        {
            motion.Displace(place, new Vector3D(wreck.Body.Forward.X, wreck.Body.Forward.Y, 0), sliding.Length);
            vehicle.MoveStaged(wreck.PoseOn(slope), sliding.Length, velocity, blocked);
            return;
        }

        LanePlace onLane =
            near.Exists(lane => lane.Path == vehicle.Path) || near.Count == 0
                ? LanePlace.Of(vehicle.Path, place, vehicle.Distance)
                : near[0];
        vehicle.MoveFreely(onLane, wreck.PoseOn(slope), sliding.Length, velocity, blocked);
    }

    private void Put(ParkedVehicle vehicle)
    {
        Footprint before = vehicle.Footprint;
        Wreck wreck = vehicle.Wreck!;
        vehicle.MoveTo(wreck.PoseOn(Settle(wreck).Slope));
        _parked.Move(vehicle, before.Centre, vehicle.Footprint.Centre);
        HasPushed?.Invoke(before, vehicle.Footprint);
    }

    /// <summary>Finds the ground below a wreck.</summary>
    private (List<LanePlace> Near, double Slope) Settle(Wreck wreck)
    {
        Vector2D forward = wreck.Body.Forward;
        List<LanePlace> near = _ground.Lanes(new Vector3D(wreck.Body.Position.X, wreck.Body.Position.Y, wreck.GroundHeight));
        (wreck.GroundHeight, double slope) = GroundBelow.At(near, new Vector3D(forward.X, forward.Y, 0), wreck.GroundHeight);
        return (near, slope);
    }

    private static double GroundOf(Pose pose, Models.Model model) => pose.Position.Z + (pose.Axes.Up.Z * model.Min.Z);

    private void StrikePeople(double timeSeconds, List<Vehicle> moved, Dictionary<Vehicle, Vector3D> before)
    {
        foreach (IPerson person in people)
        {
            if (person.IsThrown)
            {
                continue;
            }

            Footprint place = person.Footprint;
            foreach (Vehicle vehicle in vehicles)
            {
                double reach = vehicle.Length + vehicle.Model.Max.X;
                Vector3D indexed = vehicle.Pose.Position;
                if (
                    vehicle.Speed > MinSpeedAgainstPerson
                    && Horizontal.SquaredDistance(vehicle.Footprint.Centre, place.Centre) < reach * reach
                    && vehicle.Footprint.Overlaps(place)
                    && Strike(vehicle, person, place, timeSeconds)
                )
                {
                    if (before.TryAdd(vehicle, indexed))
                    {
                        moved.Add(vehicle);
                    }

                    break;
                }
            }
        }
    }

    private bool Strike(Vehicle vehicle, IPerson person, Footprint place, double timeSeconds)
    {
        PlanarBody body = vehicle.Wreck?.Body ?? BodyAt(vehicle.Model, vehicle.Footprint);
        body.Velocity = vehicle.Wreck is null ? Flat(vehicle.Velocity) : body.Velocity;

        // A person does not turn a vehicle's push into spin; the body is limp.
        PlanarBody limp = new(VehicleMass.Person, double.PositiveInfinity, place.HalfLength, place.HalfWidth)
        {
            Position = Flat(place.Centre),
            Yaw = Math.Atan2(place.Forward.Y, place.Forward.X),
            Velocity = Flat(person.Velocity),
        };
        if (BodyContact.Between(body, limp) is not { } contact)
        {
            return false;
        }

        double closing = (body.VelocityAt(contact.Point) - limp.Velocity).Dot(contact.Normal);
        Vector2D impulse = ImpactLaw.Impulse(body, limp, contact, restitution: 0, friction: 0);
        if (impulse == default)
        {
            return false;
        }

        body.Push(impulse * -1, contact.Point);
        limp.Push(impulse, contact.Point);
        vehicle.Wreck ??= new Wreck(body, vehicle.Model, vehicle.Extents, GroundOf(vehicle.Pose, vehicle.Model));
        Put(vehicle);
        Vector2D clear = contact.Normal * contact.Depth;
        person.Throw(new Vector3D(clear.X, clear.Y, 0), limp.Velocity, GroundAt);
        _impacts.Add(new Impact(timeSeconds, vehicle.Handle, person.Handle, impulse, contact.Point, contact.Normal, closing));
        return true;
    }

    private static Vector2D Flat(Vector3D vector) => new(vector.X, vector.Y);
}
