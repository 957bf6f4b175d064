using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Simulation.Streets;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>The routes of the simulation's traffic through the junctions of a map, and whether its ways have them.</summary>
internal sealed class DrivenWays(LaneNetwork map, Site site)
{
    /// <summary>Half the width of a car, metres.</summary>
    private const double HalfCar = 0.95;

    /// <summary>Distance of the places looked at on a route, metres.</summary>
    private const double Step = 1;

    /// <summary>Ways and roads within a junction that a route has at most.</summary>
    private const int MaxParts = 7;

    private readonly Dictionary<(MapLane From, MapLane To), bool> _routes = [];

    /// <summary>
    /// The junctions whose ways all lie within a radius: the number of ways, of those that the traffic drives from lane to lane, and of
    /// those on which it stays within the edges.
    /// </summary>
    public IEnumerable<(MapJunction Junction, int Ways, int Driven, int Kept)> Judge(Vector3D centre, double radius)
    {
        foreach (LanePath way in site.Lanes.Paths.Where(path => path.Junction is { Arms.Count: > 1 }))
        {
            if (LaneAt(way.Line.PositionAt(0), way.Line.TangentAt(0)) is { } from)
            {
                Follow(from, [way]);
            }
        }

        foreach (MapJunction junction in map.Junctions.Where(junction => junction.Ways.Count > 0))
        {
            if (junction.Ways.All(way => Horizontal.Distance(way.Centre[0], centre) < radius))
            {
                int driven = junction.Ways.Count(way => _routes.ContainsKey((way.Predecessors[0], way.Successors[0])));
                int kept = junction.Ways.Count(way => _routes.GetValueOrDefault((way.Predecessors[0], way.Successors[0])));
                yield return (junction, junction.Ways.Count, driven, kept);
            }
        }
    }

    private void Follow(MapLane from, List<LanePath> route)
    {
        LanePath last = route[^1];
        if (LaneAt(last.Line.PositionAt(last.Length), last.Line.TangentAt(last.Length)) is { } to)
        {
            Note(from, to, route);
        }

        if (route.Count < MaxParts)
        {
            foreach (LanePath next in last.Next[0].Next)
            {
                Follow(from, [.. route, last.Next[0], next]);
            }
        }
    }

    private void Note(MapLane from, MapLane to, List<LanePath> route)
    {
        MapLane[] before = [.. Chain(from, ahead: true)];
        MapLane[] after = [.. Chain(to, ahead: false)];
        if (before[^1].Successors.FirstOrDefault(way => way.Successors.Contains(after[^1])) is { } way)
        {
            bool stays = route.All(path => StaysOn(path, [.. before, way, .. after]));
            _routes[(before[^1], after[^1])] = stays || _routes.GetValueOrDefault((before[^1], after[^1]));
        }
    }

    private MapLane? LaneAt(Vector3D place, Vector3D direction) =>
        map
            .Index.Near(place, 0)
            .Where(lane => lane.Junction is null && lane.EndDirection.Dot(new Vector2D(direction.X, direction.Y)) > 0.5)
            .MinBy(lane => FromMiddle(lane, place).Distance);

    private static bool StaysOn(LanePath path, MapLane[] lanes)
    {
        for (double along = 0; along <= path.Length; along += Step)
        {
            Vector3D place = path.Line.PositionAt(along);
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
