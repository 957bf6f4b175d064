using Harvester.Geometry;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// When a driver must brake as hard as the tyres allow, where vehicles do not stop at once: something is in the way that the vehicle covers
/// while it brakes, if everything else goes on as it moves now.
/// </summary>
internal sealed class HardBraking(BodyIndex<Vehicle> vehicles, BodyIndex<Footprint> obstacles)
{
    /// <summary>Drivers look at the way in which they stop with this share of the brakes' power.</summary>
    private const double PlannedShare = 0.8;

    /// <summary>Time between the moments that are looked at, seconds, and the room that must be left, metres.</summary>
    private const double LookSeconds = 0.15;
    private const double Room = 0.2;

    /// <summary>Slower vehicles stop within the room that every vehicle looks at before it moves, m/s.</summary>
    private const double SlowSpeed = 1;

    /// <summary>Whether a vehicle must brake hard now.</summary>
    /// <param name="vehicle">The vehicle, which drives along its route.</param>
    /// <param name="braking">Deceleration at full brake, m/s².</param>
    /// <param name="walkersOnRoad">The people on the carriageways.</param>
    public bool IsNeeded(Vehicle vehicle, double braking, BodyIndex<IPerson> walkersOnRoad)
    {
        double planned = PlannedShare * braking;
        double stopping = vehicle.Speed / planned;
        if (vehicle.Speed < SlowSpeed)
        {
            return false;
        }

        for (double time = LookSeconds; time < stopping + LookSeconds; time += LookSeconds)
        {
            // s = v t - b t² / 2, up to the stop.
            double braked = Math.Min(time, stopping);
            Footprint place = vehicle.FootprintAhead((vehicle.Speed * braked) - (planned * braked * braked / 2)).Grown(Room);
            var look = new Look(vehicle, place, braked);
            if (
                vehicles.AnyNear(place.Centre, look, static (other, look) => look.Meets(other))
                || obstacles.AnyNear(place.Centre, look, static (other, look) => look.Place.Overlaps(other))
                || walkersOnRoad.AnyNear(place.Centre, look, static (person, look) => look.Meets(person))
            )
            {
                return true;
            }
        }

        return false;
    }

    private readonly record struct Look(Vehicle Vehicle, Footprint Place, double Seconds)
    {
        public bool Meets(Vehicle other) =>
            other != Vehicle
            && !(Vehicle.IsBlindToStaged && other.Staged is not null)
            && IsAhead(other.Footprint)
            && Meets(other.Footprint, other.Velocity);

        public bool Meets(IPerson person) =>
            !(Vehicle.IsBlindToStaged && person is StagedPerson) && Meets(person.Footprint, person.Velocity);

        private bool Meets(Footprint other, Vector3D velocity) =>
            Place.Overlaps(other with { Centre = other.Centre + (velocity * Seconds) });

        /// <summary>Who comes from behind has to brake, not this driver.</summary>
        private bool IsAhead(Footprint other) => (other.Centre - Vehicle.Footprint.Centre).Dot(Vehicle.Footprint.Forward) > 0;
    }
}
