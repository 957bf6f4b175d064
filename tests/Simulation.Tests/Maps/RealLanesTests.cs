using Harvester.Datasets.Props;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Streets;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>The lane map of GTA V's roads and lights.</summary>
[Trait("Category", "Heavy")]
public sealed class RealLanesTests(ITestOutputHelper output)
{
    /// <summary>
    /// The least part of the ways that the traffic drives, and on which it stays within the edges. Neither depends on chance:
    /// measured are 0.807 and 0.597, and less would be a change for the worse.
    /// </summary>
    private const double MinDriven = 0.8;
    private const double MinKept = 0.59;

    /// <summary>The least part of the ways that a car can follow between their edges; measured is 0.991.</summary>
    private const double MinFollowed = 0.99;

    private static readonly Vector2D[] Places =
    [
        new(0, -1000),
        new(0, 200),
        new(1000, -1500),
        new(2000, 3000),
        new(-1500, -400),
        new(300, -800),
        new(-700, -1000),
        new(-1200, -1400),
        new(800, -200),
        new(-500, 300),
        new(1200, -600),
        new(400, -1800),
        new(-300, -1600),
        new(-1000, 200),
        new(300, 300),
        new(1700, 3700),
        new(-200, 6300),
        new(-3000, 400),
        new(1100, 2700),
        new(-800, -300),
    ];

    [RealWorldFact("nodes.zip")]
    public void Lanes_of_the_games_roads_meet() => Assert.Equal((0, 0), LaneGaps.Of(MapOf(MapContent.None), output));

    [RealWorldFact("worldTrafficLights.json")]
    public void Nearly_every_light_of_the_game_faces_lanes()
    {
        IReadOnlyList<MapProp> lights = MapProps.Of(
            PropPlacementImporter.Import(RealWorldFactAttribute.PathOf("worldTrafficLights.json")!)
        );

        LaneNetwork map = MapOf(new MapContent { Props = lights });

        int facing = map.Signals.Count(signal => signal.Lanes.Count > 0);
        output.WriteLine($"{lights.Count} lights, {map.Signals.Count} places, {facing} face lanes");
        // Some stand where the road data has no road that they face.
        Assert.InRange(facing, map.Signals.Count * 0.9, map.Signals.Count);
    }

    [RealWorldFact("nodes.zip")]
    public void Traffic_stays_on_the_ways_through_junctions()
    {
        const double radius = 300;
        RoadNetwork network = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        LaneNetwork map = LaneNetwork.Of(new RoadCurves(network), new LaneModel(network));
        var found = new List<(MapJunction Junction, WayUse[] Ways)>();
        foreach (Vector2D place in ProofSize.Of(Places[..10], Places))
        {
            var centre = new Vector3D(place.X, place.Y, 0);
            var plan = RoadPlan.Build(network, centre, radius + 150, Settlement.Of(network, centre));
            var index = new StreetIndex(plan.Roads);
            var graph = new LaneGraph(plan, new AsphaltHeights(index, new RoadLevels(plan.Roads, index)));
            found.AddRange(new DrivenWays(map, graph).Judge(centre, radius));
        }

        // Places lie so close together that some share junctions.
        found = [.. found.DistinctBy(judged => judged.Junction)];
        WayUse[] ways = [.. found.SelectMany(judged => judged.Ways)];
        int plausible = found.Count(judged => judged.Ways.All(way => way == WayUse.Kept));
        int driven = found.Count(judged => judged.Ways.All(IsDriven));
        output.WriteLine(
            $"{plausible} of {found.Count} junctions: traffic stays on all their ways; {driven}: it drives all; {ways.Length} ways"
        );
        foreach (IGrouping<WayUse, WayUse> use in ways.GroupBy(way => way).OrderBy(use => use.Key))
        {
            output.WriteLine($"  {use.Key}: {use.Count()} ways, in {found.Count(judged => judged.Ways.Contains(use.Key))} junctions");
        }

        Assert.True(ways.Count(IsDriven) > MinDriven * ways.Length);
        Assert.True(ways.Count(way => way == WayUse.Kept) > MinKept * ways.Length);
    }

    private static bool IsDriven(WayUse way) => way is WayUse.Kept or WayUse.Left;

    [RealWorldFact("nodes.zip")]
    public void Car_follows_the_ways_through_junctions()
    {
        LaneNetwork map = MapOf(MapContent.None);
        (int Ways, int Kept)[] junctions =
        [
            .. map
                .Junctions.Where(junction => junction.Ways.Count > 0)
                .Select(junction => (junction.Ways.Count, junction.Ways.Count(FollowingCar.StaysOn))),
        ];
        int ways = junctions.Sum(junction => junction.Ways);
        int kept = junctions.Sum(junction => junction.Kept);
        output.WriteLine(
            $"a car follows {kept} of {ways} ways, all ways in {junctions.Count(each => each.Kept == each.Ways)} of {junctions.Length} "
                + "junctions"
        );
        Assert.True(kept > MinFollowed * ways);
    }

    [RealWorldFact("nodes.zip")]
    public void Lanes_without_a_lane_before_or_after_have_a_cause()
    {
        LaneNetwork map = MapOf(MapContent.None);
        var causes = new LaneEnds(map);
        foreach ((bool atEnd, string name) in ((bool, string)[])[(true, "end"), (false, "begin")])
        {
            IGrouping<LaneEndCause, MapLane>[] found =
            [
                .. map
                    .Lanes.Where(lane => (atEnd ? lane.Successors : lane.Predecessors).Count == 0)
                    .GroupBy(lane => causes.Of(lane, atEnd)),
            ];
            output.WriteLine($"{found.Sum(group => group.Count())} lanes {name}:");
            foreach (IGrouping<LaneEndCause, MapLane> group in found.OrderBy(group => group.Key))
            {
                output.WriteLine($"  {group.Count()} {group.Key}: {string.Join(" ", group.Take(3).Select(lane => lane.Id))}");
            }

            Assert.DoesNotContain(found, group => group.Key == LaneEndCause.None);
        }
    }

    private static LaneNetwork MapOf(MapContent content)
    {
        RoadNetwork network = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        return LaneNetwork.Of(new RoadCurves(network), new LaneModel(network), content);
    }
}
