using Harvester.Simulation.Settings;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>Interventions in a world.</summary>
/// <param name="vehicles">All vehicles, the ego first.</param>
/// <param name="walkers">The people who walk by themselves.</param>
/// <param name="people">All people.</param>
/// <param name="traffic">The traffic.</param>
/// <param name="stage">The actors that somebody has put into the world; null if it has no stage.</param>
internal sealed class WorldChanges(
    List<Vehicle> vehicles,
    List<Walker> walkers,
    List<IPerson> people,
    TrafficFlow traffic,
    WorldStage? stage
)
{
    /// <summary>Acceleration of an actor that takes another speed, m/s².</summary>
    private const double UsualAcceleration = 2;

    /// <summary>Makes a change of a driver, or removes an entity.</summary>
    /// <param name="change">The change.</param>
    /// <param name="timeSeconds">The world's time.</param>
    /// <exception cref="ArgumentException">There is no such vehicle or person, or it cannot be changed so.</exception>
    public void Make(WorldChange change, double timeSeconds)
    {
        switch (change.Kind)
        {
            case WorldChangeKind.Brake when MotionOf(change) is { } motion:
                motion.Change(0, change.Value, change.Seconds);
                break;
            case WorldChangeKind.Drive when MotionOf(change) is { } motion:
                motion.Change(change.Value, UsualAcceleration, seconds: null);
                break;
            case WorldChangeKind.Brake:
                Brake(VehicleOf(change), change, timeSeconds);
                break;
            case WorldChangeKind.Drive:
                VehicleOf(change).CruiseSpeed = change.Value;
                break;
            case WorldChangeKind.Remove:
                Remove(change);
                break;
            default:
                throw new ArgumentException($"{change.Kind} is no change of an entity.", nameof(change));
        }
    }

    private static void Brake(Vehicle vehicle, WorldChange change, double timeSeconds) =>
        vehicle.Ordered = new OrderedBraking(change.Value, change.Seconds is { } seconds ? timeSeconds + seconds : double.PositiveInfinity);

    private void Remove(WorldChange change)
    {
        if (change.Handle == 0 || change.Handle == vehicles[0].Handle)
        {
            throw new ArgumentException("The ego vehicle cannot be taken out of the world.", nameof(change));
        }

        if (MotionOf(change) is not null)
        {
            stage!.Remove(change.Handle);
            return;
        }

        if (people.Find(person => person.Handle == change.Handle) is { } person)
        {
            people.Remove(person);
            walkers.RemoveAll(walker => walker == person);
            return;
        }

        Vehicle vehicle = VehicleOf(change);
        vehicles.Remove(vehicle);
        traffic.Leave(vehicle);
    }

    private StagedMotion? MotionOf(WorldChange change) => change.Handle == 0 ? null : stage?.MotionOf(change.Handle);

    private Vehicle VehicleOf(WorldChange change) =>
        change.Handle == 0
            ? vehicles[0]
            : vehicles.Find(vehicle => vehicle.Handle == change.Handle || (change.Handle == vehicle.RiderHandle && change.Handle != 0))
                ?? throw new ArgumentException(
                    $"The world has no vehicle in traffic and no person on foot with the handle {change.Handle}.",
                    nameof(change)
                );
}
