using Harvester.Simulation.Settings;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>Interventions in a world.</summary>
/// <param name="vehicles">All vehicles, the ego first.</param>
/// <param name="walkers">The people who walk by themselves.</param>
/// <param name="people">All people.</param>
/// <param name="traffic">The traffic.</param>
internal sealed class WorldChanges(List<Vehicle> vehicles, List<Walker> walkers, List<IPerson> people, TrafficFlow traffic)
{
    /// <summary>Makes a change of a driver, or removes an entity.</summary>
    /// <param name="change">The change.</param>
    /// <param name="timeSeconds">The world's time.</param>
    /// <exception cref="ArgumentException">There is no such vehicle or person, or it cannot be changed so.</exception>
    public void Make(WorldChange change, double timeSeconds)
    {
        switch (change.Kind)
        {
            case WorldChangeKind.Brake:
                Brake(VehicleOf(change), change, timeSeconds);
                break;
            case WorldChangeKind.Drive:
                Drive(VehicleOf(change), change.Value);
                break;
            case WorldChangeKind.Remove:
                Remove(change);
                break;
            default:
                throw new ArgumentException($"{change.Kind} is no change of an entity.", nameof(change));
        }
    }

    private static void Brake(Vehicle vehicle, WorldChange change, double timeSeconds)
    {
        if (vehicle.Staged is { } motion)
        {
            motion.SetSpeed(0, change.Value);
            return;
        }

        vehicle.Ordered = new OrderedBraking(change.Value, change.Seconds is { } seconds ? timeSeconds + seconds : double.PositiveInfinity);
    }

    private static void Drive(Vehicle vehicle, double speed)
    {
        const double usualAcceleration = 2;
        vehicle.Staged?.SetSpeed(speed, usualAcceleration);
        vehicle.CruiseSpeed = speed;
    }

    private void Remove(WorldChange change)
    {
        if (change.Handle == 0 || change.Handle == vehicles[0].Handle)
        {
            throw new ArgumentException("The ego vehicle cannot be taken out of the world.", nameof(change));
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

    private Vehicle VehicleOf(WorldChange change) =>
        change.Handle == 0
            ? vehicles[0]
            : vehicles.Find(vehicle => vehicle.Handle == change.Handle || (change.Handle == vehicle.RiderHandle && change.Handle != 0))
                ?? throw new ArgumentException(
                    $"The world has no vehicle in traffic and no person on foot with the handle {change.Handle}.",
                    nameof(change)
                );
}
