using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>The paths on which a town's traffic drives, found by where they run: an independent reference for the lanes of a map.</summary>
internal sealed class TrafficPaths
{
    /// <summary>Lanes of one road lie farther apart than this, metres.</summary>
    private const double SameLane = 1;

    private readonly LanePath[] _roads;
    private readonly Dictionary<string, LanePath?> _found = [];

    public TrafficPaths(LaneGraph lanes) => _roads = [.. lanes.Paths.Where(path => path.Road is not null)];

    /// <summary>The path of a lane outside junctions; null if there is none.</summary>
    public LanePath? Of(MapLane lane)
    {
        if (!_found.TryGetValue(lane.Id, out LanePath? path))
        {
            Vector3D middle = lane.Centre[lane.Centre.Count / 2];
            Vector3D ahead = lane.Centre[^1] - lane.Centre[0];
            path = _roads
                .Select(road => (Road: road, Nearest: Nearest(road, middle)))
                .Where(pair => pair.Nearest.Distance < SameLane && pair.Road.Line.TangentAt(pair.Nearest.Along).Dot(ahead) > 0)
                .OrderBy(pair => pair.Nearest.Distance)
                .Select(pair => pair.Road)
                .FirstOrDefault();
            _found.Add(lane.Id, path);
        }

        return path;
    }

    /// <summary>
    /// The path that leads to a lane. Traffic stops farther from junctions than lanes of the map reach: there, that of the lanes before.
    /// </summary>
    public LanePath? Before(MapLane lane) => FirstOf(lane, at => at.Predecessors);

    /// <summary>The path to which a lane leads, as <see cref="Before"/>.</summary>
    public LanePath? After(MapLane lane) => FirstOf(lane, at => at.Successors);

    private LanePath? FirstOf(MapLane lane, Func<MapLane, IReadOnlyList<MapLane>> next)
    {
        MapLane? at = lane;
        while (at is not null && Of(at) is null)
        {
            at = next(at).FirstOrDefault(other => other.Junction is null);
        }

        return at is null ? null : Of(at);
    }

    private static (double Distance, double Along) Nearest(LanePath path, Vector3D point)
    {
        (double best, double along, double travelled) = (double.PositiveInfinity, 0, 0);
        IReadOnlyList<Vector3D> points = path.Line.Points;
        for (int i = 1; i < points.Count; i++)
        {
            double apart = new Vector2D(points[i].X - point.X, points[i].Y - point.Y).Length;
            travelled += (points[i] - points[i - 1]).Length;
            if (apart < best)
            {
                (best, along) = (apart, travelled);
            }
        }

        return (best, along);
    }
}
