using Harvester.Geometry;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// Lets bodies collide: after vehicles have moved as their drivers want, those that touch exchange impulses and become wrecks, and people
/// who are struck are thrown.
/// </summary>
internal sealed class CrashFlow
{
    /// <summary>A way longer than that at its speed by this, metres, is a vehicle that was placed elsewhere.</summary>
    private const double Displaced = 1;

    private readonly Dictionary<Vehicle, Footprint> _before = [];
    private readonly WreckGround _ground;
    private readonly PersonStrikes _strikes;
    private readonly BodyIndex<ParkedVehicle> _parkedNear = new();
    private readonly IReadOnlyList<Vehicle> _vehicles;
    private readonly IReadOnlyList<ParkedVehicle> _parked;
    private readonly double[] _egoStruckAt = [double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity];
    private List<Impact> _impacts = [];
    private double _timeSeconds;

    /// <param name="lanes">The lanes, which are the ground.</param>
    /// <param name="vehicles">All vehicles; the first is the ego.</param>
    /// <param name="parked">The parked vehicles.</param>
    /// <param name="people">The people on foot.</param>
    public CrashFlow(LaneGraph lanes, IReadOnlyList<Vehicle> vehicles, IReadOnlyList<ParkedVehicle> parked, IReadOnlyList<IPerson> people)
    {
        (_vehicles, _parked) = (vehicles, parked);
        _ground = new WreckGround(lanes);
        _strikes = new PersonStrikes(vehicles, people, _ground);
        foreach (ParkedVehicle vehicle in _parked)
        {
            _parkedNear.Add(vehicle, vehicle.Footprint.Centre);
        }
    }

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
        foreach (Vehicle vehicle in _vehicles)
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
        foreach (Vehicle vehicle in _vehicles)
        {
            Gather(bodies, vehicle, seconds, index);
        }

        foreach (ParkedVehicle vehicle in _parked)
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

        _strikes.Strike(timeSeconds, moved, before, _impacts);
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

    private Vehicle Ego => _vehicles[0];

    private EgoContact KindOf(int handle) =>
        _vehicles.Any(vehicle => vehicle.Handle == handle) ? EgoContact.Vehicle
        : _parked.Any(vehicle => vehicle.Prop.Handle == handle) ? EgoContact.Parked
        : EgoContact.Pedestrian;

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

        foreach (ParkedVehicle other in _parkedNear.Near(swept.Centre))
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
            VehicleBodies.Flat(before.Centre),
            Math.Atan2(before.Forward.Y, before.Forward.X),
            VehicleBodies.Flat(vehicle.Footprint.Centre),
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
        PlanarBody body = vehicle.Wreck?.Body ?? VehicleBodies.At(vehicle.Prop.Model, vehicle.Footprint);
        double deceleration = VehicleMass.IsTwoWheeler(vehicle.Prop.Model) ? Grip.LyingSlide : Grip.Sliding;
        return new CrashBody(vehicle.Prop.Handle, body, vehicle.Footprint.Centre.Z, deceleration);
    }

    /// <summary>Moves the vehicles of bodies that nobody drives, and returns those in traffic.</summary>
    private List<Vehicle> Take(SortedDictionary<int, CrashBody> bodies, double seconds, Dictionary<Vehicle, Vector3D> before)
    {
        List<Vehicle> moved = [];
        foreach (Vehicle vehicle in _vehicles)
        {
            if (bodies.TryGetValue(vehicle.Handle, out CrashBody? body) && body.Way is null)
            {
                vehicle.Wreck ??= new Wreck(body.Body, vehicle.Model, vehicle.Extents, WreckGround.Below(vehicle.Pose, vehicle.Model));
                vehicle.Wreck.Tick(seconds);
                before.Add(vehicle, vehicle.Pose.Position);
                _ground.Put(vehicle);
                moved.Add(vehicle);
            }
        }

        foreach (ParkedVehicle vehicle in _parked)
        {
            if (bodies.TryGetValue(vehicle.Prop.Handle, out CrashBody? body) && (body.IsStruck || vehicle.Wreck is not null))
            {
                vehicle.Wreck ??= new Wreck(
                    body.Body,
                    vehicle.Prop.Model,
                    (vehicle.Prop.Model.Min, vehicle.Prop.Model.Max),
                    WreckGround.Below(vehicle.Prop.Pose, vehicle.Prop.Model)
                );
                vehicle.Wreck.Tick(seconds);
                Footprint stood = vehicle.Footprint;
                _ground.Put(vehicle);
                _parkedNear.Move(vehicle, stood.Centre, vehicle.Footprint.Centre);
                HasPushed?.Invoke(stood, vehicle.Footprint);
            }
        }

        return moved;
    }
}
