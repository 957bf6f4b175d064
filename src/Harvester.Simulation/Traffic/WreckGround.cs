using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Puts wrecks on the ground, which is that of the lanes.</summary>
/// <param name="lanes">The lanes.</param>
internal sealed class WreckGround(LaneGraph lanes)
{
    private readonly GroundBelow _ground = new(lanes);

    /// <summary>Height of the ground at a place, metres; the given height where there is no lane.</summary>
    public double At(Vector3D place, double height) =>
        _ground.Lanes(place) is [var lane, ..] ? lane.Path.Line.PositionAt(lane.Distance).Z : height;

    /// <summary>Puts a wreck of the traffic where its body is.</summary>
    public void Put(Vehicle vehicle)
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

    /// <summary>Puts a parked vehicle where its body is.</summary>
    public void Put(ParkedVehicle vehicle) => vehicle.MoveTo(vehicle.Wreck!.PoseOn(Settle(vehicle.Wreck).Slope));

    /// <summary>Finds the ground below a wreck.</summary>
    private (List<LanePlace> Near, double Slope) Settle(Wreck wreck)
    {
        Vector2D forward = wreck.Body.Forward;
        List<LanePlace> near = _ground.Lanes(new Vector3D(wreck.Body.Position.X, wreck.Body.Position.Y, wreck.GroundHeight));
        (wreck.GroundHeight, double slope) = GroundBelow.At(near, new Vector3D(forward.X, forward.Y, 0), wreck.GroundHeight);
        return (near, slope);
    }

    /// <summary>Height of the ground below a vehicle on its wheels, metres.</summary>
    public static double Below(Pose pose, Model model) => pose.Position.Z + (pose.Axes.Up.Z * model.Min.Z);
}
