using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>What a world has near a place: to draw, to read as entities, and to light it at night.</summary>
/// <param name="vehicles">The vehicles in traffic; the first is the ego.</param>
/// <param name="people">Everyone on foot.</param>
/// <param name="loose">The parked vehicles of a world with crashes, in which they can move.</param>
/// <param name="fixtures">What never moves and is an entity.</param>
/// <param name="signals">The traffic lights.</param>
/// <param name="lampPlaces">The street lamps, metres.</param>
/// <param name="replayed">The traffic of a log; null without one.</param>
internal sealed class WorldContents(
    IReadOnlyList<Vehicle> vehicles,
    IReadOnlyList<IPerson> people,
    IReadOnlyList<ParkedVehicle> loose,
    IReadOnlyList<Prop> fixtures,
    SignalProps signals,
    IReadOnlyList<Vector3D> lampPlaces,
    ReplayedTraffic? replayed
)
{
    /// <summary>The handle of a moving entity that is neither drawn nor read; 0 if there is none.</summary>
    public int HiddenHandle { get; set; }

    /// <summary>Whether it is so dark that vehicles in traffic have their headlights on.</summary>
    public bool IsDark { get; set; }

    private IEnumerable<ReplayedBody> ReplayedBodies => replayed?.Present.Where(body => body.Handle != HiddenHandle) ?? [];

    /// <summary>Objects that move or change within a distance of a position at a time, seconds, without the ego.</summary>
    public IEnumerable<MeshInstance> MovingNear(Vector3D place, double range, double timeSeconds)
    {
        double squared = range * range;
        return vehicles
            .Skip(1)
            .Where(vehicle => vehicle.Handle != HiddenHandle && (vehicle.Pose.Position - place).LengthSquared < squared)
            .SelectMany(vehicle => vehicle.Instances(LightsOf(vehicle, timeSeconds)))
            .Concat(
                people
                    .Where(walker => (walker.Pose.Position - place).LengthSquared < squared)
                    .Select(walker => new MeshInstance(walker.Look, walker.Pose, walker.Handle))
            )
            .Concat(
                ReplayedBodies
                    .Where(body => (body.Pose.Position - place).LengthSquared < squared)
                    .SelectMany(body => body.Instances(IsDark))
            )
            .Concat(
                loose.Where(vehicle => (vehicle.Prop.Pose.Position - place).LengthSquared < squared).Select(vehicle => vehicle.Instance)
            )
            .Concat(signals.Instances(timeSeconds).Where(signal => (signal.Pose.Position - place).LengthSquared < squared));
    }

    /// <summary>The entities within a distance of a position at a time, without the ego, in the order of their handles.</summary>
    public List<EntityState> EntitiesNear(Vector3D place, double range, double timeSeconds)
    {
        double squared = range * range;
        IEnumerable<EntityState> driven = vehicles
            .Skip(1)
            .Where(vehicle => IsNear(vehicle.Pose))
            .Select(vehicle => new EntityState(
                vehicle.Handle,
                vehicle.Model.Class,
                vehicle.Model.Name,
                vehicle.Pose,
                vehicle.Model.Min,
                vehicle.Model.Max,
                vehicle.Velocity
            )
            {
                HasRider = VehicleClasses.HaveRiders(vehicle.Model.Class) ? true : null,
                Lights = VehicleClasses.AreVehicles(vehicle.Model.Class) ? LightsOf(vehicle, timeSeconds) : null,
            });
        IEnumerable<EntityState> riders = vehicles
            .Skip(1)
            .Where(vehicle => vehicle.Rider is not null && vehicle.Handle != HiddenHandle && IsNear(vehicle.Pose))
            .Select(vehicle => new EntityState(
                vehicle.RiderHandle,
                ObjectClass.Rider,
                vehicle.Rider!.Name,
                vehicle.Pose,
                vehicle.Rider.Min,
                vehicle.Rider.Max,
                vehicle.Velocity
            )
            {
                VehicleHandle = vehicle.Handle,
                Skeleton = vehicle.Rider.Skeletons[0].MovedBy(vehicle.Pose),
            });
        IEnumerable<EntityState> walkers = people
            .Where(walker => IsNear(walker.Pose))
            .Select(walker => new EntityState(
                walker.Handle,
                walker.Model.Class,
                walker.Model.Name,
                walker.Pose,
                walker.Model.Min,
                walker.Model.Max,
                walker.Velocity
            )
            {
                Skeleton = walker.Skeleton,
            });
        IEnumerable<EntityState> props = fixtures
            .Where(prop => IsNear(prop.Pose))
            .Select(prop => prop.State)
            .Concat(loose.Where(vehicle => IsNear(vehicle.Prop.Pose)).Select(vehicle => vehicle.State));
        return
        [
            .. driven
                .Concat(riders)
                .Concat(walkers)
                .Concat(ReplayedBodies.Where(body => IsNear(body.Pose)).SelectMany(body => body.Entities(IsDark)))
                .Concat(props)
                .Concat(signals.States.Where(signal => IsNear(signal.Pose)))
                .Where(entity => entity.Handle != HiddenHandle)
                .OrderBy(entity => entity.Handle),
        ];

        bool IsNear(Pose pose) => (pose.Position - place).LengthSquared < squared;
    }

    /// <summary>The handle of the vehicle nearest to a position, without the ego; 0 if there is none.</summary>
    public int VehicleNearest(Vector3D place) =>
        vehicles.Skip(1).MinBy(vehicle => (vehicle.Pose.Position - place).LengthSquared)?.Handle ?? 0;

    /// <summary>The nearest street lamps and headlights, which light the scene at night.</summary>
    public List<LightSource> LightsNear(Vector3D eye)
    {
        const double range = 120;
        const int maxLamps = 14;
        const int maxVehicles = 8;
        const double lampAhead = 2;
        IEnumerable<LightSource> lamps = lampPlaces
            .Where(lamp => (lamp - eye).Length < range)
            .OrderBy(lamp => (lamp - eye).LengthSquared)
            .Take(maxLamps)
            .Select(LightSource.StreetLamp);
        IEnumerable<LightSource> headlights = vehicles
            .Where(vehicle => vehicle.Model.Lamps is not null)
            .Where(vehicle => (vehicle.Pose.Position - eye).Length < range)
            .OrderBy(vehicle => (vehicle.Pose.Position - eye).LengthSquared)
            .Take(maxVehicles)
            .Select(vehicle => LightSource.Headlights(vehicle.Pose.ToWorld(new Vector3D(0, lampAhead, 0)), vehicle.Pose.Axes.Forward));
        return [.. lamps, .. headlights];
    }

    private VehicleLights LightsOf(Vehicle vehicle, double timeSeconds) => vehicle.Signals.At(vehicle, timeSeconds, IsDark);
}
