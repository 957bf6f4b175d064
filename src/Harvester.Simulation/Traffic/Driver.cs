using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// A driver's use of the pedals: the intelligent driver model of Treiber, Hennecke and Helbing (2000), with a comfortable speed in bends,
/// and with people on the road and stop lines treated as standing vehicles.
/// </summary>
internal static class Driver
{
    // The model's parameters for city traffic: a and b in m/s², s0 in metres and T in seconds. Published are a = 0.73, b = 1.67, s0 = 2 and
    // T = 1.6 for motorways; towns are brisker.
    private const double Acceleration0 = 2;
    private const double ComfortableBraking = 2.5;
    private const double StandingGap = 2;
    private const double TimeGapSeconds = 1.2;

    /// <summary>Exponent of the free acceleration, δ of the model.</summary>
    private const double FreeExponent = 4;

    /// <summary>Deceleration of which tyres are capable on a dry road, m/s².</summary>
    private const double HardestBraking = 8;

    /// <summary>Room between the front of a standing vehicle and the line, metres.</summary>
    private const double RoomAtLine = 0.5;

    /// <summary>Minimum of the gap in the interaction term, metres, so that it stays finite when bodies touch.</summary>
    private const double MinGap = 0.1;

    /// <summary>Comfortable acceleration across the vehicle in bends, m/s².</summary>
    private const double SidewaysAcceleration = 2.2;

    /// <summary>How far ahead bends slow down, and the distance between the points that are looked at, metres.</summary>
    private const double BendLookAhead = 36;
    private const double BendStep = 3;

    /// <summary>Minimum curvature by which the speed in bends is divided, 1/m; it limits no speed.</summary>
    private const double MinBend = 1e-6;

    /// <summary>How far ahead a vehicle is followed, metres.</summary>
    private const double LeaderRange = 60;

    /// <summary>Factors on the cruise speed.</summary>
    private const double MotorwayFactor = 1.4;
    private const double UnpavedFactor = 0.7;

    public static double Acceleration(Vehicle vehicle, LaneOccupation occupation, double distanceToStop, BodyIndex<IPerson> walkersOnRoad)
    {
        double freeShare = vehicle.Speed > 0 ? Math.Pow(vehicle.Speed / DesiredSpeed(vehicle), FreeExponent) : 0;
        (double gap, double leaderSpeed) = Leader(vehicle, occupation);

        // A line is a standing vehicle whose rear is StandingGap - RoomAtLine beyond it: the model comes to rest StandingGap before that.
        double stop = Math.Min(distanceToStop, DistanceToWalker(vehicle, walkersOnRoad)) - vehicle.FrontOverhang;
        double interaction = Math.Max(
            Interaction(vehicle.Speed, gap, leaderSpeed),
            Interaction(vehicle.Speed, stop + StandingGap - RoomAtLine, 0)
        );

        // dv/dt = a (1 - (v / v0)^δ - (s* / s)²).
        return Math.Clamp(Acceleration0 * (1 - freeShare - (interaction * interaction)), -HardestBraking, Acceleration0);
    }

    /// <summary>The ratio of the desired gap to the actual one.</summary>
    private static double Interaction(double speed, double gap, double leaderSpeed)
    {
        // s* = s0 + max(0, v T + v Δv / (2 √(a b))).
        double wanted =
            StandingGap
            + Math.Max(0, (speed * TimeGapSeconds) + (speed * (speed - leaderSpeed) / (2 * Math.Sqrt(Acceleration0 * ComfortableBraking))));
        return wanted / Math.Max(gap, MinGap);
    }

    private static double DesiredSpeed(Vehicle vehicle)
    {
        Road? road = vehicle.Path.Road;
        double desired =
            vehicle.CruiseSpeed
            * (
                vehicle.IsSpeedGiven ? 1
                : road is { IsHighway: true } ? MotorwayFactor
                : road is { IsUnpaved: true } ? UnpavedFactor
                : 1
            );
        double minSquared = double.PositiveInfinity;
        for (double ahead = 0; ahead <= BendLookAhead; ahead += BendStep)
        {
            (LanePath path, double distance) = vehicle.PlaceAhead(ahead);
            double bend = path.Line.BendAt(distance);

            // In the bend v² κ = sideways acceleration; before it v² = v_bend² + b s, which takes half of the comfortable braking and
            // leaves the other half to the model.
            double slowestSquared = SidewaysAcceleration / Math.Max(bend, MinBend);
            minSquared = Math.Min(minSquared, slowestSquared + (ComfortableBraking * ahead));
        }

        return Math.Min(desired, Math.Sqrt(minSquared));
    }

    /// <summary>The vehicle ahead on its route: the gap to it, metres, infinite without one, and its speed.</summary>
    public static (double Gap, double Speed) Leader(Vehicle vehicle, LaneOccupation occupation)
    {
        double toStart = -vehicle.Distance;
        foreach (LanePath path in vehicle.Route)
        {
            Vehicle? leader = null;
            foreach (Vehicle other in occupation.On(path))
            {
                double distance = other.DistanceOn(path);
                leader =
                    other != vehicle
                    && !(vehicle.IsBlindToStaged && other.Staged is not null)
                    && toStart + distance > 0
                    && (leader is null || distance < leader.DistanceOn(path))
                        ? other
                        : leader;
            }

            if (leader is not null)
            {
                // Bumper to bumper: origins are inside the vehicles.
                return (toStart + leader.DistanceOn(path) - leader.RearOverhang - vehicle.FrontOverhang, leader.SpeedOn(path));
            }

            toStart += path.Length;
            if (toStart > LeaderRange)
            {
                break;
            }
        }

        return (double.PositiveInfinity, 0);
    }

    private static double DistanceToWalker(Vehicle vehicle, BodyIndex<IPerson> walkersOnRoad)
    {
        const double halfLane = 2.2;
        const double step = 1.5;

        // Stopping distance v² / (2 b) and a few metres.
        double range = vehicle.FrontOverhang + 4 + (vehicle.Speed * vehicle.Speed / (2 * ComfortableBraking));
        if (walkersOnRoad.IsEmpty)
        {
            return double.PositiveInfinity;
        }

        IPerson[] near =
        [
            .. walkersOnRoad
                .Near(vehicle.PoseAhead(range / 2).Position)
                .Where(person => !(vehicle.IsBlindToStaged && person is StagedPerson)),
        ];
        for (double ahead = vehicle.FrontOverhang; near.Length > 0 && ahead < range; ahead += step)
        {
            Vector3D place = vehicle.PoseAhead(ahead).Position;
            if (near.Any(walker => Horizontal.Distance(walker.Pose.Position, place) < halfLane))
            {
                return ahead - StandingGap;
            }
        }

        return double.PositiveInfinity;
    }
}
