using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Moves the pedestrians.</summary>
internal sealed class WalkerFlow
{
    private const double StandingVehicleRoom = 7;
    private const double ArrivalSeconds = 6;
    private const double RestingSpeed = 0.3;

    private readonly IReadOnlyList<Walker> _walkers;
    private readonly ILookup<Road, Walkway> _walkwaysOf;
    private readonly BodyIndex<IPerson> _onRoad = new();

    public WalkerFlow(IReadOnlyList<Walker> walkers, IEnumerable<Walkway> walkways)
    {
        _walkers = walkers;
        _walkwaysOf = walkways.ToLookup(walkway => walkway.Road);
    }

    /// <summary>Somewhere pedestrians of the traffic do not begin to cross: a middle and a radius, metres; null for nowhere.</summary>
    public (Vector3D Middle, double Radius)? Quiet { get; set; }

    /// <summary>People who were put into the world.</summary>
    public List<StagedPerson> Staged { get; } = [];

    /// <summary>The pedestrians on a carriageway now; valid until the next call.</summary>
    public BodyIndex<IPerson> OnRoad()
    {
        _onRoad.Clear();
        foreach (Walker walker in _walkers.Where(walker => walker.IsOnRoad))
        {
            _onRoad.Add(walker, walker.Pose.Position);
        }

        foreach (StagedPerson person in Staged.Where(person => person.IsOnRoad))
        {
            _onRoad.Add(person, person.Pose.Position);
        }

        return _onRoad;
    }

    /// <summary>Moves all, or those within a distance of a position.</summary>
    public void Tick(double seconds, TrafficFlow traffic, Vector3D place, double? radius)
    {
        Func<Walkway, double, Walkway?> opposite = Opposite;
        Func<Vector3D, bool> isSafe = place =>
            IsSafe(place, traffic) && !(Quiet is { } quiet && Horizontal.Distance(place, quiet.Middle) < quiet.Radius);
        double squared = radius * radius ?? double.PositiveInfinity;
        foreach (Walker walker in _walkers)
        {
            if (Horizontal.SquaredDistance(walker.Pose.Position, place) > squared)
            {
                continue;
            }

            walker.Tick(seconds, opposite, isSafe);
        }
    }

    private static bool IsSafe(Vector3D place, TrafficFlow traffic) =>
        !traffic.AnyNear(
            place,
            static (vehicle, place) =>
            {
                double distance = Horizontal.Distance(vehicle.Pose.Position, place);
                bool isFar =
                    vehicle.Speed < RestingSpeed
                        ? distance > StandingVehicleRoom + vehicle.FrontOverhang
                        : distance > vehicle.FrontOverhang + StandingVehicleRoom + (vehicle.Speed * ArrivalSeconds / 3);
                return !isFar;
            }
        );

    private Walkway? Opposite(Walkway walkway, double distance)
    {
        const double nearEnd = 3;
        return _walkwaysOf[walkway.Road]
            .FirstOrDefault(other => other.OnRight != walkway.OnRight && distance > other.From - nearEnd && distance < other.To + nearEnd);
    }
}
