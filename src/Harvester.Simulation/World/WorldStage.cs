using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>The actors that somebody has put into the world.</summary>
internal sealed class WorldStage
{
    /// <summary>Time in which the traffic around the cleared place gets under way, seconds, in steps of the world's longest tick.</summary>
    private const int WarmTicks = 60;

    private readonly StageSetting _setting;
    private readonly ModelCatalogue _catalogue;
    private readonly HandleCounter _handles;
    private readonly StagedTraffic _staged;
    private readonly TrafficFlow _traffic;
    private readonly WalkerFlow _walking;
    private readonly Dictionary<int, Vehicle> _actors = [];
    private readonly Dictionary<int, StagedPerson> _persons = [];
    private List<Vehicle> _vehicles = [];
    private List<IPerson> _people = [];

    public WorldStage(
        StageSetting setting,
        ModelCatalogue catalogue,
        HandleCounter handles,
        StagedGround ground,
        TrafficFlow traffic,
        WalkerFlow walking
    )
    {
        (_setting, _catalogue, _handles, _traffic, _walking) = (setting, catalogue, handles, traffic, walking);
        _staged = traffic.Stage(ground);
    }

    private Vehicle Ego => _vehicles[0];

    /// <summary>Lets the traffic get under way while the ego waits, clears the place of it, and lets the ego begin.</summary>
    /// <param name="vehicles">All vehicles, the ego first; actors are added to them.</param>
    /// <param name="people">All people; actors are added to them.</param>
    /// <param name="tick">Moves the world by a tick.</param>
    public void Enter(List<Vehicle> vehicles, List<IPerson> people, Action tick)
    {
        (_vehicles, _people) = (vehicles, people);
        if (_setting.Way.Count > 0)
        {
            Lead(_setting.Way);
        }

        _walking.Quiet = (Ego.Pose.Position, _setting.ClearMetres);
        _traffic.HoldsEgo = true;
        Clear();
        for (int i = 0; i < WarmTicks; i++)
        {
            tick();
        }

        Clear();
        _traffic.HoldsEgo = false;
        Ego.Speed = _setting.Speed;
        Ego.StandingSeconds = 0;
    }

    /// <summary>Puts an actor into the world.</summary>
    public StageSpawn Spawn(StageActor actor)
    {
        if (StageModels.Find(_catalogue, actor) is not { } model)
        {
            return StageSpawn.Refused($"The simulated game has no model '{actor.Model}'.");
        }

        var motion = new StagedMotion(actor.Ground, Axes.FromHeading(actor.HeadingDegrees).Forward, actor.Speed);
        int handle = _handles.Next();
        if (actor.Kind == StageKind.Pedestrian)
        {
            var person = new StagedPerson(handle, model, motion);
            person.Stand(_staged.Ground);
            _persons.Add(handle, person);
            _people.Add(person);
            _walking.Staged.Add(person);
            return StageSpawn.Of(handle);
        }

        var vehicle = new Vehicle(handle, model, actor.Number, 0) { Staged = motion };
        vehicle.RiderHandle = vehicle.Rider is null ? 0 : _handles.Next();
        _staged.Ground.Stand(vehicle);
        if (_traffic.IsTaken(vehicle.Footprint))
        {
            return StageSpawn.Refused(
                FormattableString.Invariant(
                    $"Something stands at {actor.Ground.X:0.0}, {actor.Ground.Y:0.0}, where '{actor.Model}' is to be."
                )
            );
        }

        _actors.Add(handle, vehicle);
        _vehicles.Add(vehicle);
        _traffic.Enter(vehicle);
        return StageSpawn.Of(handle);
    }

    public void Follow(int handle, StageOrder order) =>
        MotionToOrder(handle)?.Follow(new StagedWay(order.Path), order.Speed, order.Acceleration, order.IsBackwards, order.IgnoresOthers);

    public void SetSpeed(int handle, double speed, double acceleration) => MotionToOrder(handle)?.SetSpeed(speed, acceleration);

    public void SetDoor(int handle, int side, bool isOpen)
    {
        if (_actors.TryGetValue(handle, out Vehicle? vehicle))
        {
            vehicle.OpenDoor = isOpen ? side : 0;
            _staged.Ground.Stand(vehicle);
        }
    }

    public void SetIndicators(int handle, StageIndicators indicators)
    {
        if (_actors.TryGetValue(handle, out Vehicle? vehicle))
        {
            vehicle.Signals.Ordered = indicators;
        }
    }

    /// <summary>Takes an actor out of the world.</summary>
    /// <param name="handle">Its handle, or that of its rider.</param>
    public void Remove(int handle)
    {
        int driven = _actors.FirstOrDefault(actor => actor.Key == handle || (handle != 0 && actor.Value.RiderHandle == handle)).Key;
        if (_actors.Remove(driven, out Vehicle? vehicle))
        {
            _vehicles.Remove(vehicle);
            _traffic.Leave(vehicle);
        }

        if (_persons.Remove(handle, out StagedPerson? person))
        {
            _people.Remove(person);
            _walking.Staged.Remove(person);
        }
    }

    public StageState? StateOf(int handle) =>
        _actors.TryGetValue(handle, out Vehicle? vehicle) ? StateOf(vehicle.Pose, vehicle.Velocity, vehicle.Staged!, vehicle.Model)
        : _persons.TryGetValue(handle, out StagedPerson? person) ? StateOf(person.Pose, person.Velocity, person.Motion, person.Model)
        : null;

    /// <summary>Sends the ego's own driver along a way.</summary>
    public void DriveEgo(StageOrder order)
    {
        Ego.IsBlindToStaged = order.IgnoresOthers;
        Ego.CruiseSpeed = order.Speed;
        Ego.IsSpeedGiven = true;
        Lead(order.Path);
    }

    /// <summary>Moves the people.</summary>
    public void TickPeople(double seconds)
    {
        foreach (StagedPerson person in _persons.Values)
        {
            person.Tick(seconds, _staged.Ground);
        }
    }

    private static StageState StateOf(Pose pose, Vector3D velocity, StagedMotion motion, Model model) =>
        new(pose, velocity, motion.IsAtEnd, (model.Max.Y - model.Min.Y) / 2, (model.Max.X - model.Min.X) / 2);

    /// <summary>The motion of an actor; null if there is no such actor.</summary>
    /// <param name="handle">Its handle, or that of its rider.</param>
    public StagedMotion? MotionOf(int handle) =>
        _actors.TryGetValue(handle, out Vehicle? vehicle) ? vehicle.Staged
        : _persons.TryGetValue(handle, out StagedPerson? person) ? person.Motion
        : _actors.Values.FirstOrDefault(ridden => ridden.RiderHandle != 0 && ridden.RiderHandle == handle)?.Staged;

    /// <summary>The motion of an actor that still takes orders.</summary>
    private StagedMotion? MotionToOrder(int handle) => MotionOf(handle) is { IsChanged: false } motion ? motion : null;

    private void Lead(IReadOnlyList<Vector3D> way)
    {
        Ego.Guide = choices => StageStart.Along(way, choices);
        Ego.PlanAgain();
    }

    /// <summary>Takes the vehicles in traffic out of the surroundings of the ego.</summary>
    private void Clear()
    {
        Vehicle[] near =
        [
            .. _vehicles.Skip(1).Where(vehicle => Horizontal.Distance(vehicle.Pose.Position, Ego.Pose.Position) < _setting.ClearMetres),
        ];
        foreach (Vehicle vehicle in near)
        {
            _vehicles.Remove(vehicle);
            _traffic.Leave(vehicle);
        }
    }
}
