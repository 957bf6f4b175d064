using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Streets;
using Harvester.Simulation.World;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>The lane map of a town's road data, compared with the lanes on which its traffic drives.</summary>
public sealed class LaneNetworkTests(ITestOutputHelper output)
{
    /// <summary>The deviation that is allowed, metres.</summary>
    private const double MaxDeviation = 0.05;

    /// <summary>Lanes of one road lie farther apart than this, metres.</summary>
    private const double SameLane = 1;

    /// <summary>A path this near to the middle lies on the lane, metres: less than half of the narrowest.</summary>
    private const double OnLane = 2;

    /// <summary>A shorter path is what is left of a road between the stop lines of two junctions, metres.</summary>
    private const double MinLength = 3;

    [Theory]
    [InlineData(461)]
    [InlineData(462)]
    [InlineData(463)]
    [Trait("Category", "Heavy")]
    public void Lanes_and_ways_are_those_of_the_towns_traffic(int seed)
    {
        Site site = Site.OfTown(seed);
        var map = LaneNetwork.Of(new RoadCurves(site.Network), new LaneModel(site.Network));
        LanePath[] roads = [.. site.Lanes.Paths.Where(path => path.Road is not null && !IsPoint(path))];
        var pathOf = map.Lanes.Where(lane => lane.Junction is null).ToDictionary(lane => lane, lane => PathOf(lane, roads));

        double[] deviations =
        [
            .. pathOf
                .Where(pair => pair.Value is not null)
                .SelectMany(pair => pair.Key.Centre.Select(point => DeviationFrom(point, pair.Value!)))
                .OfType<double>(),
        ];
        (int From, int To)[] truth =
        [
            .. from way in site.Lanes.Paths
            where way.Junction is not null && !IsPoint(way.Previous[0])
            from next in BeyondPoints(way.Next[0])
            select (way.Previous[0].Index, next.Index),
        ];
        (int From, int To)[] found =
        [
            .. map
                .Junctions.SelectMany(junction => junction.Ways)
                .Select(way => (Towards(way.Predecessors[0], pathOf, ahead: false), Towards(way.Successors[0], pathOf, ahead: true)))
                .Concat(
                    from lane in pathOf.Keys
                    from next in lane.Successors
                    where next.Junction is null && pathOf[lane] is not null && pathOf[next] is not null
                    select (pathOf[lane]!.Index, pathOf[next]!.Index)
                )
                // A path of the traffic goes on through junctions of one road.
                .Where(pair => pair.Item1 != pair.Item2),
        ];
        output.WriteLine(
            $"{pathOf.Count} lanes; {deviations.Length} points, deviation at most {deviations.Max():0.0000} m; "
                + $"{truth.Distinct().Count()} ways, {truth.Except(found).Count()} missing, {found.Except(truth).Count()} too many"
        );
        foreach ((int from, int to) in truth.Except(found).Take(8).Concat(found.Except(truth).Take(8)))
        {
            output.WriteLine($"  {Describe(from, site)} -> {Describe(to, site)}");
        }

        // Where a lane has no path of a road, its traffic is on a way through a junction already.
        MapLane[] lost =
        [
            .. pathOf
                .Where(pair => pair.Value is null)
                .Select(pair => pair.Key)
                .Where(lane => PathOf(lane, site.Lanes.Paths, OnLane) is null),
        ];
        output.WriteLine(
            $"{pathOf.Values.Count(path => path is null)} lanes lie within junctions of the traffic, {lost.Length} have no path at all"
        );
        Assert.Empty(lost);
        Assert.InRange(deviations.Max(), 0, MaxDeviation);
        Assert.Empty(truth.Except(found));
        Assert.Empty(found.Except(truth));
    }

    [Theory]
    [InlineData(464)]
    [InlineData(465)]
    public void Lanes_that_follow_each_other_meet(int seed)
    {
        RoadNetwork network = TownBuilder.Build(seed);

        Assert.Equal((0, 0), LaneGaps.Of(LaneNetwork.Of(new RoadCurves(network), new LaneModel(network)), output));
    }

    private static string Describe(int index, Site site)
    {
        if (index < 0)
        {
            return "none";
        }

        LanePath path = site.Lanes.Paths[index];
        Vector3D end = path.Line.PositionAt(path.Length);
        Vector3D start = path.Line.PositionAt(0);
        return $"{index} lane {path.Lane} ({start.X:0},{start.Y:0})-({end.X:0},{end.Y:0})";
    }

    /// <summary>The path whose line runs through the middle of a lane, in its direction; null if there is none.</summary>
    private static LanePath? PathOf(MapLane lane, IReadOnlyList<LanePath> paths, double maxDistance = SameLane)
    {
        Vector3D middle = lane.Centre[lane.Centre.Count / 2];
        Vector3D ahead = lane.Centre[^1] - lane.Centre[0];
        return paths
            .Select(path => (Path: path, Nearest: NearestOn(path, middle)))
            .Where(pair => pair.Nearest.Distance < maxDistance && pair.Path.Line.TangentAt(pair.Nearest.Along).Dot(ahead) > 0)
            .OrderBy(pair => pair.Nearest.Distance)
            .Select(pair => pair.Path)
            .FirstOrDefault();
    }

    /// <summary>Whether a path of the traffic has next to no length: its road lies within the stop lines of two junctions.</summary>
    private static bool IsPoint(LanePath path) => path.Length < MinLength;

    private static IEnumerable<LanePath> BeyondPoints(LanePath path) =>
        IsPoint(path) ? path.Next.SelectMany(way => BeyondPoints(way.Next[0])) : [path];

    /// <summary>
    /// The number of a lane's path. Its traffic stops farther from junctions than the map's lanes reach: there, that of the lanes before or
    /// behind it; -1 if these have none either.
    /// </summary>
    private static int Towards(MapLane lane, Dictionary<MapLane, LanePath?> pathOf, bool ahead)
    {
        MapLane? at = lane;
        while (at is not null && pathOf[at] is null)
        {
            at = (ahead ? at.Successors : at.Predecessors).FirstOrDefault(next => next.Junction is null);
        }

        return at is null ? -1 : pathOf[at]!.Index;
    }

    /// <summary>Distance of a point from a path's line on the ground; null where the path does not reach.</summary>
    private static double? DeviationFrom(Vector3D point, LanePath path)
    {
        (double distance, _, bool isAtEnd) = NearestOn(path, point);
        return isAtEnd ? null : distance;
    }

    private static (double Distance, double Along, bool IsAtEnd) NearestOn(LanePath path, Vector3D point)
    {
        (double best, double along, double travelled, bool isAtEnd) = (double.PositiveInfinity, 0, 0, true);
        IReadOnlyList<Vector3D> points = path.Line.Points;
        for (int i = 1; i < points.Count; i++)
        {
            var from = new Vector2D(points[i - 1].X, points[i - 1].Y);
            Vector2D piece = new Vector2D(points[i].X, points[i].Y) - from;
            Vector2D to = new Vector2D(point.X, point.Y) - from;
            double t = Math.Clamp(piece.Dot(to) / Math.Max(piece.Dot(piece), double.Epsilon), 0, 1);
            double apart = (to - (piece * t)).Length;
            if (apart < best)
            {
                (best, along) = (apart, travelled + (t * piece.Length));
                isAtEnd = (i == 1 && t == 0) || (i == points.Count - 1 && t == 1);
            }

            travelled += piece.Length;
        }

        return (best, along, isAtEnd);
    }
}
