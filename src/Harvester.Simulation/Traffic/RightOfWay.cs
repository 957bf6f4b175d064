using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// Decides who may drive into a junction: first come, first served among conflicting paths, with the lights at green and room behind the
/// junction, and at a stop sign only after a stop. Where the road behind the junction is too short for the vehicle, the junctions after it
/// must be free as well, because the vehicle would otherwise stand in the first one.
/// </summary>
internal sealed class RightOfWay(LaneGraph lanes, LaneControl control, LaneOccupation occupation)
{
    /// <summary>A driver asks for a way where it would have to brake like this for the line, m/s², and this many metres earlier.</summary>
    private const double BrakingForStop = 2;
    private const double AskEarlier = 8;

    /// <summary>Room that a vehicle keeps behind the junction besides its length, metres.</summary>
    private const double RoomBehind = 2;

    /// <summary>A driver who would have to brake harder than this for a light that is no longer green drives on, m/s².</summary>
    private const double HardestForLight = 4;

    /// <summary>Below this speed a vehicle stands, m/s.</summary>
    private const double StandingSpeed = 0.1;

    /// <summary>Metres between a vehicle's front and the line within which it has stopped at the line.</summary>
    private const double StopRange = 3;

    /// <summary>The next vehicle may take the room behind the last one where that will have stopped if it brakes like this, m/s².</summary>
    private const double BrakingOfOthers = 3;

    /// <summary>After this time at the line a driver is let in: conflicting paths are no longer granted to others.</summary>
    private const double PatienceSeconds = 2;

    /// <summary>
    /// A driver who has stood on its granted way for this long no longer has the right of way: others drive on as far as bodies have room.
    /// One of them may be what it waits for.
    /// </summary>
    private const double HeldUpSeconds = 4;

    private readonly List<Vehicle>?[] _users = new List<Vehicle>?[lanes.Paths.Count];
    private readonly List<Vehicle>?[] _claimants = new List<Vehicle>?[lanes.Paths.Count];
    private readonly Dictionary<Vehicle, List<LanePath>> _claims = [];
    private readonly Dictionary<LanePath, List<Vehicle>> _bound = [];

    /// <summary>
    /// Metres from the vehicle's origin to the line where it has to stop; infinite if its path is free as far as it needs.
    /// </summary>
    public double DistanceToStop(Vehicle vehicle, double timeSeconds)
    {
        double distance = vehicle.Path.Length - vehicle.Distance;
        NoteStop(vehicle, distance - vehicle.FrontOverhang);

        // Stopping distance v² / (2 b) of the front, and some metres so that a way is granted before the driver brakes.
        double range = (vehicle.Speed * vehicle.Speed / (2 * BrakingForStop)) + AskEarlier + vehicle.FrontOverhang;
        for (int i = 1; i < vehicle.Route.Count && distance < range; i++)
        {
            LanePath way = vehicle.Route[i];
            if (way.Junction is not null)
            {
                // A grant ends when the light leaves green while the vehicle can still stop; then it asks again, and is refused at the red
                // light.
                if (vehicle.Granted.Contains(way) && MustStopForLight(vehicle, i, distance, timeSeconds))
                {
                    TakeBack(vehicle, i);
                }

                if (!vehicle.Granted.Contains(way) && !MayEnter(vehicle, i, timeSeconds))
                {
                    return distance;
                }
            }

            distance += way.Length;
        }

        return double.PositiveInfinity;
    }

    public void ReleasePassed(Vehicle vehicle)
    {
        for (int i = vehicle.Granted.Count - 1; i >= 0; i--)
        {
            // The way has left the route when the origin is past it; the rear is past it after the rear overhang.
            if (!vehicle.Route.Contains(vehicle.Granted[i]) && vehicle.Distance > vehicle.RearOverhang)
            {
                Release(vehicle, i);
            }
        }
    }

    public void ReleaseAll(Vehicle vehicle)
    {
        ReleaseClaim(vehicle);
        while (vehicle.Granted.Count > 0)
        {
            Release(vehicle, vehicle.Granted.Count - 1);
        }

        vehicle.StoppedOn = null;
    }

    private static void NoteStop(Vehicle vehicle, double metresToLine)
    {
        bool standsAtLine = vehicle.Speed < StandingSpeed && metresToLine < StopRange && vehicle.Path.Road is not null;

        // A stop at a line counts until the vehicle has left its lane.
        vehicle.StoppedOn = standsAtLine || vehicle.StoppedOn == vehicle.Path ? vehicle.Path : null;
    }

    /// <summary>
    /// Whether the light of a granted way has left green and the vehicle can still stop. A way that was granted with the one before it,
    /// because the road between is too short to wait there, stays granted.
    /// </summary>
    private bool MustStopForLight(Vehicle vehicle, int index, double distance, double timeSeconds)
    {
        LanePath lane = vehicle.Route[index - 1];
        return lane.Length >= NeededRoom(vehicle)
            && control.LightFor(lane, vehicle.Route[index].Junction!, timeSeconds) is SignalState.Amber or SignalState.Red
            // The way to the line is longer than the braking distance v² / (2 · HardestForLight).
            && distance - vehicle.FrontOverhang > vehicle.Speed * vehicle.Speed / (2 * HardestForLight);
    }

    /// <summary>Takes back the granted ways of the route from one on.</summary>
    private void TakeBack(Vehicle vehicle, int index)
    {
        foreach (LanePath way in vehicle.Route.Skip(index))
        {
            if (vehicle.Granted.IndexOf(way) is >= 0 and var granted)
            {
                Release(vehicle, granted);
            }
        }
    }

    private void Release(Vehicle vehicle, int index)
    {
        LanePath way = vehicle.Granted[index];
        _users[way.Index]!.Remove(vehicle);
        vehicle.Granted.RemoveAt(index);
        if (_bound.TryGetValue(way.Next[0], out List<Vehicle>? bound))
        {
            bound.Remove(vehicle);
        }
    }

    /// <summary>Grants the way through a junction, with those that it has to be granted with, if all of them are free.</summary>
    private bool MayEnter(Vehicle vehicle, int index, double timeSeconds)
    {
        // A way is granted together with all that follow up to the first road that has room: granted singly, vehicles could block each
        // other in short roads for good.
        List<LanePath> ways = WaysToRoom(vehicle, index);
        LanePath lane = ways[0].Previous[0];
        LanePath exit = ways[^1].Next[0];

        // The claim of the last tick ends; it is made again below if the vehicle still has to wait.
        ReleaseClaim(vehicle);
        if (
            control.LightFor(lane, ways[0].Junction!, timeSeconds) is SignalState.Amber or SignalState.Red
            || (control.HasStopSign(lane, ways[0].Junction!) && vehicle.StoppedOn != lane)
            || !HasRoom(vehicle, exit)
        )
        {
            return false;
        }

        // Free means that no vehicle has been granted a conflicting way, unless it is held up there, and nobody who has waited longer
        // claims one.
        if (ways.TrueForAll(way => IsFree(vehicle, way)))
        {
            ways.ForEach(way => Grant(vehicle, way));
            (_bound.TryGetValue(exit, out List<Vehicle>? bound) ? bound : _bound[exit] = []).Add(vehicle);
            return true;
        }

        if (vehicle.StandingSeconds > PatienceSeconds)
        {
            Claim(vehicle, ways);
        }

        return false;
    }

    /// <summary>The ways through junctions from one of the route on, up to the first road on which the vehicle has room.</summary>
    private static List<LanePath> WaysToRoom(Vehicle vehicle, int index)
    {
        List<LanePath> ways = [vehicle.Route[index]];
        double needed = NeededRoom(vehicle);

        // Routes alternate between ways through junctions and roads, so index + 1 is a road and index + 2 the next way.
        for (int i = index + 1; i + 1 < vehicle.Route.Count && vehicle.Route[i].Length < needed; i += 2)
        {
            ways.Add(vehicle.Route[i + 1]);
        }

        return ways;
    }

    private static double NeededRoom(Vehicle vehicle) => vehicle.Length + RoomBehind;

    private void Grant(Vehicle vehicle, LanePath way)
    {
        if (!vehicle.Granted.Contains(way))
        {
            vehicle.Granted.Add(way);
            (_users[way.Index] ??= []).Add(vehicle);
        }
    }

    private bool IsFree(Vehicle vehicle, LanePath way) =>
        vehicle.Granted.Contains(way) || (way.Conflicts.TrueForAll(other => !IsUsed(other, vehicle)) && !IsClaimed(vehicle, way));

    private bool IsUsed(LanePath way, Vehicle asking) =>
        _users[way.Index] is { } users && users.Exists(user => user != asking && user.StandingSeconds < HeldUpSeconds);

    private void Claim(Vehicle vehicle, List<LanePath> ways)
    {
        _claims[vehicle] = ways;
        ways.ForEach(way => (_claimants[way.Index] ??= []).Add(vehicle));
    }

    private void ReleaseClaim(Vehicle vehicle)
    {
        if (_claims.Remove(vehicle, out List<LanePath>? ways))
        {
            ways.ForEach(way => _claimants[way.Index]!.Remove(vehicle));
        }
    }

    /// <summary>
    /// Whether a driver who has waited longer is let in first. The one who has waited longest of all thus waits only for those who are on
    /// their way already.
    /// </summary>
    private bool IsClaimed(Vehicle vehicle, LanePath way) =>
        way.Conflicts.Exists(other =>
            _claimants[other.Index] is { } claimants && claimants.Exists(first => HasWaitedLonger(first, vehicle))
        );

    private static bool HasWaitedLonger(Vehicle first, Vehicle second) =>
        first != second
        && (
            first.StandingSeconds > second.StandingSeconds
            || (first.StandingSeconds == second.StandingSeconds && first.Handle < second.Handle)
        );

    /// <summary>Whether a lane behind a junction has room for the vehicle and for those that are on their way to it.</summary>
    private bool HasRoom(Vehicle vehicle, LanePath exit)
    {
        double needed = NeededRoom(vehicle);
        if (_bound.TryGetValue(exit, out List<Vehicle>? bound))
        {
            // Vehicles on their way to the lane will stand in it before this one, each with its room.
            needed += bound.Where(other => other != vehicle && other.Path != exit).Sum(other => other.Length + RoomBehind);
        }

        Vehicle? last = occupation.On(exit).Where(other => other != vehicle).MinBy(other => other.DistanceOn(exit));
        if (last is null)
        {
            // An empty lane that is shorter than what is needed still takes a single vehicle; otherwise it could never be entered.
            return exit.Length >= needed || bound is not { Count: > 0 };
        }

        // Room up to where the rear of the last vehicle will have come to rest if it brakes, v² / (2 · BrakingOfOthers) farther on.
        double speed = last.SpeedOn(exit);
        return last.DistanceOn(exit) - last.RearOverhang + (speed * speed / (2 * BrakingOfOthers)) > needed;
    }
}
