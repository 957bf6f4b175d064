using Harvester.Geometry;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Impacts of vehicles on people.</summary>
/// <param name="vehicles">All vehicles.</param>
/// <param name="people">The people on foot.</param>
/// <param name="ground">The ground.</param>
internal sealed class PersonStrikes(IReadOnlyList<Vehicle> vehicles, IReadOnlyList<IPerson> people, WreckGround ground)
{
    /// <summary>A person who walks against a slower vehicle is not thrown, m/s.</summary>
    private const double MinSpeedAgainstPerson = 0.5;

    /// <summary>Lets vehicles throw the people whom they touch.</summary>
    /// <param name="timeSeconds">The world's time.</param>
    /// <param name="moved">Receives the vehicles that have struck somebody.</param>
    /// <param name="before">Receives where they were.</param>
    /// <param name="impacts">Receives the impacts.</param>
    public void Strike(double timeSeconds, List<Vehicle> moved, Dictionary<Vehicle, Vector3D> before, List<Impact> impacts)
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
                    && Strike(vehicle, person, place, timeSeconds, impacts)
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

    private bool Strike(Vehicle vehicle, IPerson person, Footprint place, double timeSeconds, List<Impact> impacts)
    {
        PlanarBody body = vehicle.Wreck?.Body ?? VehicleBodies.At(vehicle.Model, vehicle.Footprint);
        body.Velocity = vehicle.Wreck is null ? VehicleBodies.Flat(vehicle.Velocity) : body.Velocity;

        // A person does not turn a vehicle's push into spin; the body is limp.
        PlanarBody limp = new(VehicleMass.Person, double.PositiveInfinity, place.HalfLength, place.HalfWidth)
        {
            Position = VehicleBodies.Flat(place.Centre),
            Yaw = Math.Atan2(place.Forward.Y, place.Forward.X),
            Velocity = VehicleBodies.Flat(person.Velocity),
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
        vehicle.Wreck ??= new Wreck(body, vehicle.Model, vehicle.Extents, WreckGround.Below(vehicle.Pose, vehicle.Model));
        ground.Put(vehicle);
        Vector2D clear = contact.Normal * contact.Depth;
        person.Throw(new Vector3D(clear.X, clear.Y, 0), limp.Velocity, ground.At);
        impacts.Add(new Impact(timeSeconds, vehicle.Handle, person.Handle, impulse, contact.Point, contact.Normal, closing));
        return true;
    }
}
