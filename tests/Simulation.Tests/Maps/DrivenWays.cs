using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>The routes of the simulation's traffic through the junctions of a map, and whether its ways have them.</summary>
internal sealed class DrivenWays(LaneNetwork map, LaneGraph graph)
{
    /// <summary>Half the width of a car, metres.</summary>
    private const double HalfCar = 0.95;

    /// <summary>Distance of the places looked at on a route, metres.</summary>
    private const double Step = 1;

    /// <summary>How far before a way its lane is looked for, metres.</summary>
    private const double MaxSearch = 60;

    /// <summary>A path this near to the middle of a lane is the lane's, metres.</summary>
    private const double SameLane = 1;

    /// <summary>Lanes farther above or below are those of another road, metres.</summary>
    private const double SameLevel = 5;

    /// <summary>Ways and roads within a junction that a route has at most.</summary>
    private const int MaxParts = 8;

    private readonly Dictionary<(MapLane From, MapLane To), bool> _routes = [];
    private readonly Dictionary<MapLane, HashSet<MapLane>> _reached = [];

    /// <summary>
    /// The junctions whose ways all lie within a radius, and what the traffic does on each of their ways.
    /// </summary>
    public IEnumerable<(MapJunction Junction, WayUse[] Ways)> Judge(Vector3D centre, double radius)
    {
        foreach (LanePath way in graph.Paths.Where(path => path.Junction is not null))
        {
            LanePath road = way.Previous[0];
            for (double along = road.Length; along > Math.Max(-Step, road.Length - MaxSearch); along -= Step)
            {
                if (LaneAt(road, along) is { } from)
                {
                    Follow(from, [(road, Math.Max(0, along), road.Length), (way, 0, way.Length)]);
                    break;
                }
            }
        }

        foreach (MapJunction junction in map.Junctions.Where(junction => junction.Ways.Count > 0))
        {
            if (junction.Ways.All(way => Horizontal.Distance(way.Centre[0], centre) < radius))
            {
                yield return (junction, [.. junction.Ways.Select(UseOf)]);
            }
        }
    }

    private WayUse UseOf(MapLane way)
    {
        (MapLane from, MapLane to) = (way.Predecessors[0], way.Successors[0]);
        return _routes.TryGetValue((from, to), out bool stays)
            ? stays
                ? WayUse.Kept
                : WayUse.Left
            : !_reached.TryGetValue(from, out HashSet<MapLane>? reached)
                ? WayUse.NoRouteBegins
                : reached.Any(lane => lane.Link == to.Link && lane.IsForward == to.IsForward)
                    ? WayUse.OtherLane
                    : WayUse.NoRouteLeadsThere;
    }

    /// <summary>Follows a route that ends with a way, along the road behind the way and the ways behind that.</summary>
    private void Follow(MapLane from, List<(LanePath Path, double From, double To)> route)
    {
        LanePath road = route[^1].Path.Next[0];
        for (double along = 0; along < road.Length + Step; along += Step)
        {
            if (LaneAt(road, along) is { } to)
            {
                Note(from, to, [.. route, (road, 0, Math.Min(along, road.Length))]);
                break;
            }
        }

        if (route.Count < MaxParts)
        {
            foreach (LanePath next in road.Next)
            {
                Follow(from, [.. route, (road, 0, road.Length), (next, 0, next.Length)]);
            }
        }
    }

    private void Note(MapLane from, MapLane to, List<(LanePath Path, double From, double To)> route)
    {
        MapLane[] before = [.. Chain(from, ahead: true)];
        MapLane[] after = [.. Chain(to, ahead: false)];
        if (!_reached.TryGetValue(before[^1], out HashSet<MapLane>? reached))
        {
            _reached.Add(before[^1], reached = []);
        }

        reached.Add(after[^1]);
        if (before[^1].Successors.FirstOrDefault(way => way.Successors.Contains(after[^1])) is { } way)
        {
            bool stays = route.All(part => StaysOn(part, [.. before, way, .. after]));
            _routes[(before[^1], after[^1])] = stays || _routes.GetValueOrDefault((before[^1], after[^1]));
        }
    }

    /// <summary>The lane of a road of the map on which a place of a path lies.</summary>
    private MapLane? LaneAt(LanePath path, double along)
    {
        double there = Math.Clamp(along, 0, path.Length);
        Vector3D place = path.Line.PositionAt(there);
        Vector3D direction = path.Line.TangentAt(there);
        return map
            .Index.Near(place, 0)
            .Where(lane => lane.Junction is null && lane.EndDirection.Dot(new Vector2D(direction.X, direction.Y)) > 0.7)
            .Where(lane => Math.Abs(lane.Centre[0].Z - place.Z) < SameLevel && FromMiddle(lane, place).Distance < SameLane)
            .MinBy(lane => FromMiddle(lane, place).Distance);
    }

    private static bool StaysOn((LanePath Path, double From, double To) part, MapLane[] lanes)
    {
        for (double along = part.From; along <= part.To; along += Step)
        {
            Vector3D place = part.Path.Line.PositionAt(along);
            if (!lanes.Any(lane => FromMiddle(lane, place) is var (distance, half) && distance + HalfCar <= half))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Distance from the middle of a lane, and half of its width.</summary>
    private static (double Distance, double Half) FromMiddle(MapLane lane, Vector3D place)
    {
        (double best, double half) = (double.PositiveInfinity, 0);
        for (int i = 1; i < lane.Centre.Count; i++)
        {
            var from = new Vector2D(lane.Centre[i - 1].X, lane.Centre[i - 1].Y);
            Vector2D piece = new Vector2D(lane.Centre[i].X, lane.Centre[i].Y) - from;
            Vector2D to = new Vector2D(place.X, place.Y) - from;
            double t = Math.Clamp(piece.Dot(to) / Math.Max(piece.Dot(piece), double.Epsilon), 0, 1);
            double apart = (to - (piece * t)).Length;
            if (apart < best)
            {
                (best, half) = (apart, (lane.Right[i] - lane.Left[i]).Length / 2);
            }
        }

        return (best, half);
    }

    /// <summary>A lane and those that follow it outside junctions, or that it follows.</summary>
    private static IEnumerable<MapLane> Chain(MapLane lane, bool ahead)
    {
        for (MapLane? at = lane; at is not null; )
        {
            yield return at;
            at = (ahead ? at.Successors : at.Predecessors).FirstOrDefault(next => next.Junction is null);
        }
    }
}
