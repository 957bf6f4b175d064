using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// Decides who may drive into a junction: first come, first served among conflicting paths, with the lights at green and room behind the
/// junction.
/// </summary>
internal sealed class RightOfWay(LaneGraph lanes, Signals signals, LaneOccupation occupation)
{
    private const double BrakingForStop = 2;
    private const double AskEarlier = 8;
    private const double RoomBehind = 2;
    private const double FlowingSpeed = 2;

    /// <summary>After this time at the line a driver is let in: conflicting paths are no longer granted to others.</summary>
    private const double PatienceSeconds = 2;

    private readonly int[] _users = new int[lanes.Paths.Count];
    private readonly Dictionary<Junction, (Vehicle Vehicle, LanePath Way)> _waiting = [];

    /// <summary>
    /// Metres from the vehicle's origin to the line where it has to stop; infinite if its path is free as far as it needs.
    /// </summary>
    public double DistanceToStop(Vehicle vehicle, double timeSeconds)
    {
        double distance = vehicle.Path.Length - vehicle.Distance;
        double range = (vehicle.Speed * vehicle.Speed / (2 * BrakingForStop)) + AskEarlier + vehicle.FrontOverhang;
        for (int i = 1; i < vehicle.Route.Count && distance < range; i++)
        {
            LanePath way = vehicle.Route[i];
            if (way.Junction is not null && !vehicle.Granted.Contains(way))
            {
                if (!MayEnter(vehicle, way, timeSeconds))
                {
                    return distance;
                }

                vehicle.Granted.Add(way);
                _users[way.Index]++;
            }

            distance += way.Length;
        }

        return double.PositiveInfinity;
    }

    public void ReleasePassed(Vehicle vehicle)
    {
        for (int i = vehicle.Granted.Count - 1; i >= 0; i--)
        {
            if (!vehicle.Route.Contains(vehicle.Granted[i]) && vehicle.Distance > vehicle.RearOverhang)
            {
                Release(vehicle, i);
            }
        }
    }

    public void ReleaseAll(Vehicle vehicle)
    {
        foreach (Junction junction in vehicle.Route.Select(way => way.Junction).OfType<Junction>())
        {
            ReleaseClaim(junction, vehicle);
        }

        while (vehicle.Granted.Count > 0)
        {
            Release(vehicle, vehicle.Granted.Count - 1);
        }
    }

    private void Release(Vehicle vehicle, int index)
    {
        _users[vehicle.Granted[index].Index]--;
        vehicle.Granted.RemoveAt(index);
    }

    private bool MayEnter(Vehicle vehicle, LanePath way, double timeSeconds)
    {
        LanePath lane = way.Previous[0];
        LanePath exit = way.Next[0];
        RoadArm arm = new(lane.Road!, AtStart: !lane.IsForward);
        Junction junction = way.Junction!;
        ReleaseClaim(junction, vehicle);

        if (signals.ColourFor(junction, arm, timeSeconds) != SignalState.Green || !HasRoom(vehicle, exit))
        {
            return false;
        }

        bool isFree = way.Conflicts.All(other => _users[other.Index] == 0) && !IsClaimed(junction, way);
        if (!isFree && vehicle.StandingSeconds > PatienceSeconds)
        {
            _waiting.TryAdd(junction, (vehicle, way));
        }

        return isFree;
    }

    private void ReleaseClaim(Junction junction, Vehicle vehicle)
    {
        if (_waiting.TryGetValue(junction, out (Vehicle Vehicle, LanePath Way) first) && first.Vehicle == vehicle)
        {
            _waiting.Remove(junction);
        }
    }

    private bool IsClaimed(Junction junction, LanePath way) =>
        _waiting.TryGetValue(junction, out (Vehicle Vehicle, LanePath Way) first) && way.Conflicts.Contains(first.Way);

    private bool HasRoom(Vehicle vehicle, LanePath exit)
    {
        List<Vehicle> ahead = occupation.On(exit);
        if (ahead.Count == 0)
        {
            return true;
        }

        Vehicle last = ahead.MinBy(other => other.DistanceOn(exit))!;
        double room = last.DistanceOn(exit) - last.RearOverhang - RoomBehind;
        return last == vehicle || last.Speed > FlowingSpeed || room > vehicle.FrontOverhang + vehicle.RearOverhang;
    }
}
