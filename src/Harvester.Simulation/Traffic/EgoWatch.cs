using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Watches how the ego drives: distance, collisions, and what it does at lights and stop signs.</summary>
/// <param name="ego">The ego.</param>
/// <param name="car">Whether a program drives it.</param>
/// <param name="traffic">The other vehicles.</param>
/// <param name="walkers">The pedestrians.</param>
/// <param name="control">The lights and stop signs.</param>
internal sealed class EgoWatch(Vehicle ego, EgoCar car, TrafficFlow traffic, IReadOnlyList<IPerson> walkers, LaneControl control)
{
    /// <summary>A car that stands within this distance of the end of its lane, metres from its origin, has stopped there.</summary>
    private const double StopRange = 10;
    private const double StandingSpeed = 0.3;

    /// <summary>A pedestrian who walks against a slower car was not run over, m/s.</summary>
    private const double MinSpeedAgainstPerson = 0.5;
    private const double PersonRange = 8;

    private readonly int[] _collisions = new int[3];
    private readonly bool[] _touched = new bool[3];
    private Vector3D? _before;
    private double _speedBefore;
    private int _replacements = traffic.EgoReplacements;
    private LanePath _path = ego.Path;
    private LanePath? _lane = ego.Path.Road is null ? null : ego.Path;
    private bool _hasStopped;
    private double _metres;
    private int _redLights;
    private int _stopSigns;
    private int _repositioned;

    /// <summary>The ego's conduct until now.</summary>
    /// <param name="timeSeconds">The game's time, which decides the state of a light.</param>
    public EgoConduct At(double timeSeconds)
    {
        (LanePath Way, double Metres)? ahead = WayAhead();
        LanePath? way = ahead is { Metres: > 0 } next ? next.Way : null;
        return new EgoConduct(
            _metres,
            [.. _collisions],
            Array.IndexOf(_touched, true) is >= 0 and var kind ? (EgoContact)kind : null,
            _redLights,
            _stopSigns,
            _repositioned,
            ahead is { } turn ? TurnOf(turn.Way) : null,
            ahead?.Metres,
            way is null ? null : control.LightFor(way.Previous[0], way.Junction!, timeSeconds)?.AsLight(),
            way is not null && control.HasStopSign(way.Previous[0], way.Junction!)
        );
    }

    /// <summary>Does not count the next way: somebody has put the ego elsewhere.</summary>
    public void Jump()
    {
        _before = null;
        _path = ego.Path;
        _lane = ego.Path.Road is null ? null : ego.Path;
        _hasStopped = false;
    }

    /// <summary>Looks at the ego after a time step.</summary>
    public void Tick(double timeSeconds)
    {
        if (traffic.EgoReplacements != _replacements)
        {
            _repositioned += traffic.EgoReplacements - _replacements;
            _replacements = traffic.EgoReplacements;
            Jump();
        }

        _metres += _before is { } before ? (ego.Pose.Position - before).Length : 0;
        _before = ego.Pose.Position;
        Touch(EgoContact.Vehicle, traffic.Crashes?.HasStruck(EgoContact.Vehicle) ?? traffic.TouchesVehicle());
        Touch(EgoContact.Parked, traffic.Crashes?.HasStruck(EgoContact.Parked) ?? traffic.TouchesObstacle());
        Touch(
            EgoContact.Pedestrian,
            traffic.Crashes?.HasStruck(EgoContact.Pedestrian)
                ?? (Math.Max(ego.Speed, _speedBefore) > MinSpeedAgainstPerson && TouchesPerson())
        );
        _speedBefore = ego.Speed;
        FollowPath(timeSeconds);
    }

    private void Touch(EgoContact kind, bool isTouching)
    {
        _collisions[(int)kind] += isTouching && !_touched[(int)kind] ? 1 : 0;
        _touched[(int)kind] = isTouching;
    }

    private bool TouchesPerson()
    {
        Vector3D place = ego.Pose.Position;
        for (int i = 0; i < walkers.Count; i++)
        {
            if (
                Horizontal.SquaredDistance(walkers[i].Pose.Position, place) < PersonRange * PersonRange
                && ego.Footprint.Overlaps(walkers[i].Footprint)
            )
            {
                return true;
            }
        }

        return false;
    }

    private void FollowPath(double timeSeconds)
    {
        if (ego.Path != _path)
        {
            if (ego.Path.Junction is { } junction && _lane is { } lane && car.IsDriven)
            {
                _redLights += control.LightFor(lane, junction, timeSeconds) == SignalState.Red ? 1 : 0;
                _stopSigns += control.HasStopSign(lane, junction) && !_hasStopped ? 1 : 0;
            }

            // A junction that was passed is behind the car, even if it left by no lane.
            _lane = ego.Path.Road is null ? null : ego.Path;
            _path = ego.Path;
            _hasStopped = false;
        }

        _hasStopped |= ego.Speed < StandingSpeed && ego.Path.Length - ego.Distance < StopRange;
    }

    /// <summary>The next way of the route through a junction with a choice, and the distance to it; the present one at 0.</summary>
    private (LanePath Way, double Metres)? WayAhead()
    {
        double metres = -ego.Distance;
        foreach (LanePath path in ego.Route)
        {
            if (path.Junction is { IsCrossing: true })
            {
                return (path, Math.Max(0, metres));
            }

            metres += path.Length;
        }

        return null;
    }

    /// <summary>The change of direction up to the road behind the junction and those so near that they belong to it.</summary>
    private RouteTurn TurnOf(LanePath way)
    {
        const double straightAtMost = 0.6;
        double turn = 0;
        bool isBehind = false;
        foreach (LanePath path in ego.Route.SkipWhile(path => path != way))
        {
            isBehind |= path.Road is { IsInner: false };
            if (isBehind)
            {
                break;
            }

            turn += Horizontal.Turn(path.Line.TangentAt(0), path.Line.TangentAt(path.Length));
        }

        return turn > straightAtMost ? RouteTurn.Left
            : turn < -straightAtMost ? RouteTurn.Right
            : RouteTurn.Straight;
    }
}
