using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Events;

/// <summary>
/// The ticks at which the conditions of the events hold that need roads, from recorded poses and the lanes and lights of the town itself.
/// </summary>
internal sealed class RoadOracle
{
    private const int Nobody = -1;
    private const double Shoulder = 2.5;
    private const double Tolerance = 1e-6;

    /// <summary>The kinds that it knows.</summary>
    public static IReadOnlyList<EventKind> Kinds { get; } =
    [EventKind.CutIn, EventKind.RedLightRun, EventKind.StopSignRun, EventKind.OffRoad, EventKind.WrongWay];

    private readonly IReadOnlyList<TrueMoment> _moments;
    private readonly Func<int, int, int> _since;
    private readonly TownLanes _lanes;
    private readonly TownLine[] _lines;
    private readonly Signals _signals;
    private readonly Dictionary<(int Handle, int Tick), TownSpot[]> _spots = [];

    /// <param name="site">The town.</param>
    /// <param name="seed">Its seed.</param>
    /// <param name="moments">The poses.</param>
    /// <param name="since">The tick since which somebody is there at a tick without having been placed elsewhere.</param>
    public RoadOracle(Site site, int seed, IReadOnlyList<TrueMoment> moments, Func<int, int, int> since)
    {
        (_moments, _since, _signals) = (moments, since, site.Signals);
        var junctions = new TownJunctions(site);
        _lanes = new TownLanes(site, junctions);
        var lights = new SignalProps(site.Signals, new HandleCounter());
        lights.AddAtStopLines(site.Index, ModelCatalogue.Shared);
        var scenery = new Scenery(seed, site, ModelCatalogue.Shared, new HandleCounter());
        scenery.AddStopSigns(site.Plan, site.Signals.Has);
        HashSet<(Junction, RoadArm)> lit = [.. lights.Lights.Select(light => (light.Junction!, light.Arm))];
        PaintedMark[] stopLines = [.. site.Marks.Where(mark => mark.Kind == MarkKind.StopLine)];
        _lines =
        [
            .. site
                .Plan.Junctions.SelectMany(junction =>
                    junction.Arms.Select(arm => new TownLine(
                        junction,
                        arm,
                        lit.Contains((junction, arm)),
                        scenery.StopArms.Contains((junction, arm)),
                        junctions.Of(arm)
                    ))
                )
                .Where(line => line.HasLight || line.HasStopSign)
                .Select(line => line.MovedTo(stopLines)),
        ];
    }

    /// <summary>The ticks at which the condition of a kind holds.</summary>
    public IEnumerable<(int First, int Second, int Tick)> Ticks(EventKind kind) =>
        kind switch
        {
            EventKind.OffRoad => Driven().Where(each => IsOffRoad(each.Handle, each.Tick)).Select(Alone),
            EventKind.WrongWay => Driven().Where(each => IsLongAgainst(each.Handle, each.Tick)).Select(Alone),
            EventKind.RedLightRun => Driven().SelectMany(each => Passages(each.Handle, each.Tick, RunsRedLight)),
            EventKind.StopSignRun => Driven().SelectMany(each => Passages(each.Handle, each.Tick, RunsStopSign)),
            _ => CutIns(),
        };

    private static (int First, int Second, int Tick) Alone((int Handle, int Tick) each) => (each.Handle, Nobody, each.Tick);

    private IEnumerable<(int Handle, int Tick)> Driven() =>
        from tick in Enumerable.Range(0, _moments.Count)
        from body in _moments[tick].Bodies
        where body.Value.IsVehicle && body.Value.Class != ObjectClass.Trailer
        select (body.Key, tick);

    private TownSpot[] SpotsOf(int handle, int tick)
    {
        if (!_spots.TryGetValue((handle, tick), out TownSpot[]? spots))
        {
            TrueBody body = _moments[tick].Bodies[handle];
            (double x, double y) = body.Middle();
            _spots.Add((handle, tick), spots = [.. _lanes.Near(new Vector3D(x, y, body.Heights().Low), Shoulder)]);
        }

        return spots;
    }

    private bool IsOffRoad(int handle, int tick) =>
        _since(handle, tick) < tick && _moments[tick].Bodies[handle].Speed >= 1 && SpotsOf(handle, tick).Length == 0;

    private bool IsLongAgainst(int handle, int tick)
    {
        for (int then = tick; then >= _since(handle, tick) && IsAgainst(handle, then); then--)
        {
            if (_moments[tick].Seconds - _moments[then].Seconds >= 1 - Tolerance)
            {
                return true;
            }
        }

        return false;
    }

    private bool IsAgainst(int handle, int tick)
    {
        TrueBody body = _moments[tick].Bodies[handle];
        double ahead = (body.Velocity.X * Math.Cos(body.Bearing)) + (body.Velocity.Y * Math.Sin(body.Bearing));
        if (body.Speed < 2 || ahead <= 0)
        {
            return false;
        }

        TownSpot[] on = [.. SpotsOf(handle, tick).Where(spot => spot.Away == 0)];
        return on.Length > 0 && on.All(spot => spot.Lane.Road is not null && Angle(spot.Bearing, body.Bearing) >= 2 * Math.PI / 3);
    }

    private static double Angle(double a, double b) => Math.Abs(Math.IEEERemainder(a - b, 2 * Math.PI));

    /// <summary>The ticks from that in which the middle of a vehicle passes a line until its rear has, if it was wrong.</summary>
    private IEnumerable<(int First, int Second, int Tick)> Passages(int handle, int tick, Func<TownLine, int, int, int, bool> isWrong)
    {
        int since = _since(handle, tick);
        foreach (TownLine line in since < tick ? _lines : [])
        {
            TrueBody body = _moments[tick].Bodies[handle];
            (double past, double right) = line.Of(body.Middle());
            if (
                past < 0
                || past > 5
                || line.Of(_moments[tick - 1].Bodies[handle].Middle()).Past >= 0
                || !line.IsOnLanes(right)
                || Angle(line.Bearing, body.Bearing) > Math.PI / 3
                || Math.Abs(body.Heights().Low - line.Height) > 3
                || !isWrong(line, handle, since, tick)
            )
            {
                continue;
            }

            yield return (handle, Nobody, tick);
            for (
                int later = tick + 1;
                later < _moments.Count
                    && _moments[later].Bodies.TryGetValue(handle, out TrueBody? then)
                    && _since(handle, later) == since
                    && line.Of(then.End(-1)).Past < 0;
                later++
            )
            {
                yield return (handle, Nobody, later);
            }
        }
    }

    private bool RunsRedLight(TownLine line, int handle, int since, int tick)
    {
        if (!line.HasLight || !IsRed(line, tick))
        {
            return false;
        }

        // The tick in which its front passed.
        int front = tick;
        while (front > since && line.Of(_moments[front - 1].Bodies[handle].End(1)).Past >= 0)
        {
            front--;
        }

        return front > since && IsRed(line, front);
    }

    private bool IsRed(TownLine line, int tick) => _signals.ColourFor(line.Junction, line.Arm, _moments[tick].Seconds) == SignalState.Red;

    private bool RunsStopSign(TownLine line, int handle, int since, int tick)
    {
        double seen = 0;
        for (int then = tick; then >= since; then--)
        {
            TrueBody body = _moments[then].Bodies[handle];
            double front = line.Of(body.End(1)).Past;
            if (front < -8)
            {
                break;
            }

            seen = front;
            if (body.Speed < 0.5)
            {
                return false;
            }
        }

        return line.HasStopSign && seen <= -4;
    }

    private IEnumerable<(int First, int Second, int Tick)> CutIns()
    {
        for (int tick = 1; tick < _moments.Count; tick++)
        {
            foreach ((int handle, int at) in Driven(tick).Where(each => each.Handle != 0))
            {
                foreach ((int first, int behind) in new[] { (handle, 0), (0, handle) })
                {
                    if (CutsIn(first, behind, tick) is not (var side and not 0))
                    {
                        continue;
                    }

                    for (int then = tick; then < _moments.Count && IsCuttingIn(first, behind, then, tick, side); then++)
                    {
                        yield return (first, behind, then);
                    }
                }
            }
        }
    }

    private IEnumerable<(int Handle, int Tick)> Driven(int tick) =>
        _moments[tick]
            .Bodies.Where(body => body.Value.IsVehicle && body.Value.Class != ObjectClass.Trailer)
            .Select(body => (body.Key, tick));

    /// <summary>The lane of a road on which somebody drives, unless it is in a junction.</summary>
    private TownSpot? LaneOf(int handle, int tick)
    {
        TownSpot[] on = [.. SpotsOf(handle, tick).Where(spot => spot.Away == 0)];
        double bearing = _moments[tick].Bodies[handle].Bearing;
        return on.Any(spot => spot.Lane.Road is null)
            ? null
            : on.Where(spot => Angle(spot.Bearing, bearing) <= Math.PI / 3)
                .OrderBy(spot => Math.Abs(spot.Right))
                .Cast<TownSpot?>()
                .FirstOrDefault();
    }

    /// <summary>From which side somebody comes into the lane of one behind: -1 from the left, 1 from the right; otherwise 0.</summary>
    private int CutsIn(int first, int behind, int tick)
    {
        if (
            _since(first, tick) == tick
            || _since(behind, tick) == tick
            || _moments[tick].Bodies[behind].Speed < 2
            || LaneOf(first, tick) is not { } now
            || LaneOf(first, tick - 1) is not { } before
            || now.Lane == before.Lane
            || before.Lane.Road != now.Lane.Road
            || before.Lane.IsForward != now.Lane.IsForward
            || LaneOf(behind, tick) is not { } follower
            || follower.Lane != now.Lane
            || LaneOf(behind, tick - 1)?.Lane != now.Lane
        )
        {
            return 0;
        }

        double gap = now.Along - follower.Along - HalfLength(first, tick) - HalfLength(behind, tick);
        return now.Along <= follower.Along || Math.Max(0, gap) / _moments[tick].Bodies[behind].Speed > 2
            ? 0
            : Math.Sign(before.Lane.Number - now.Lane.Number);
    }

    private double HalfLength(int handle, int tick)
    {
        TrueBody body = _moments[tick].Bodies[handle];
        return (body.Max.Y - body.Min.Y) / 2;
    }

    private bool IsCuttingIn(int first, int behind, int tick, int begin, int side)
    {
        if (
            !_moments[tick].Bodies.TryGetValue(first, out TrueBody? body)
            || !_moments[tick].Bodies.ContainsKey(behind)
            || _since(first, tick) > begin
            || _since(behind, tick) > begin
            || LaneOf(first, tick) is not { } now
            || LaneOf(behind, tick) is not { } follower
            || now.Lane != follower.Lane
            || now.Along <= follower.Along
        )
        {
            return false;
        }

        // The corner of the footprint that lies farthest over the edge.
        double turn = now.Bearing - Math.PI / 2;
        (double middleX, double middleY) = body.Middle();
        return body.Polygon()
            .Any(corner =>
                side * (((corner.X - middleX) * Math.Cos(turn)) + ((corner.Y - middleY) * Math.Sin(turn)) + now.Right) > now.HalfWidth
            );
    }
}
