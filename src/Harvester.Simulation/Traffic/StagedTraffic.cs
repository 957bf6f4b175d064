using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Moves staged vehicles among all others.</summary>
/// <param name="vehicles">All vehicles, by place.</param>
/// <param name="obstacles">What stands beside the lanes.</param>
/// <param name="ground">The ground.</param>
/// <param name="collides">Whether it drives on into a body that it meets, and collides with it.</param>
internal sealed class StagedTraffic(BodyIndex<Vehicle> vehicles, BodyIndex<Footprint> obstacles, StagedGround ground, bool collides)
{
    /// <summary>The ground.</summary>
    public StagedGround Ground => ground;

    /// <summary>
    /// Moves a staged vehicle as ordered. Without collisions, it stops where it meets a body, and moves on as soon as that leads away.
    /// </summary>
    public void Move(Vehicle vehicle, StagedMotion motion, double seconds, BodyIndex<IPerson> people)
    {
        Vector3D before = vehicle.Pose.Position;
        motion.Pass(seconds);
        StagedStep step = motion.After(
            seconds,
            motion.IgnoresOthers ? double.PositiveInfinity : SpeedBehindOthers(vehicle, motion, people)
        );
        Footprint next = vehicle.Footprint with
        {
            Centre = vehicle.Footprint.Centre + (step.Ground - motion.Ground),
            Forward = step.Forward,
        };
        bool isMet = !collides && step.Along > motion.Along && Meets(vehicle, next, people);
        if (isMet)
        {
            motion.Stop();
        }
        else
        {
            motion.Take(step);
        }

        ground.Stand(vehicle);
        vehicle.Signals.Tick(vehicle.Speed, seconds);
        vehicles.Move(vehicle, before, vehicle.Pose.Position);
    }

    /// <summary>Whether a vehicle would meet a body at a place ahead of it.</summary>
    private bool Meets(Vehicle vehicle, Footprint there, BodyIndex<IPerson> people) =>
        vehicles.Near(there.Centre).Any(other => other != vehicle && IsMet(vehicle.Footprint, there, other.Footprint))
        || obstacles.Near(there.Centre).Any(other => IsMet(vehicle.Footprint, there, other))
        || people.Near(there.Centre).Any(other => IsMet(vehicle.Footprint, there, other.Footprint));

    private static bool IsMet(Footprint now, Footprint next, Footprint other) =>
        next.Overlaps(other)
        && Horizontal.SquaredDistance(next.Centre, other.Centre) < Horizontal.SquaredDistance(now.Centre, other.Centre);

    /// <summary>The speed with which a staged vehicle that minds others can still stop behind what is ahead of it, m/s.</summary>
    private double SpeedBehindOthers(Vehicle vehicle, StagedMotion motion, BodyIndex<IPerson> people)
    {
        const double look = 1.5;
        const double room = 2;
        double range = room + vehicle.Length + (motion.Speed * motion.Speed / (2 * StagedMotion.StoppingDeceleration));
        for (double ahead = look; ahead < range; ahead += look)
        {
            StagedStep place = motion.Ahead(ahead);
            Footprint there = vehicle.Footprint with
            {
                Centre = vehicle.Footprint.Centre + (place.Ground - motion.Ground),
                Forward = place.Forward,
            };
            if (Meets(vehicle, there, people))
            {
                return Math.Sqrt(2 * StagedMotion.StoppingDeceleration * Math.Max(0, ahead - look - room));
            }
        }

        return double.PositiveInfinity;
    }
}
