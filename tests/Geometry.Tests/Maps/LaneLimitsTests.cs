using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Geometry.Work;

namespace Harvester.Geometry.Tests.Maps;

/// <summary>Hostile road data and places, which must neither exhaust the memory nor keep a search from ending.</summary>
public sealed class LaneLimitsTests
{
    private const double Far = 1e12;

    [Theory]
    [InlineData(0)]
    [InlineData(Far)]
    [InlineData(-Far)]
    [InlineData(1e15)]
    public void Lanes_and_lights_are_looked_for_anywhere(double place)
    {
        var there = new Vector3D(place, -place, 0);
        var content = new MapContent { Props = [new MapProp(MapSignalKind.Light, "prop_traffic_01a", there, new Vector3D(0, 1, 0))] };
        LaneNetwork map = LaneNetwork.Of(new RoadCurves(Star(4)), new LaneModel(Star(4)), content);

        Assert.Single(map.Signals);
        Assert.Equal(place == 0, map.Index.Near(there, 70).Any());
    }

    [Fact]
    public void Roads_far_from_the_origin_have_a_map()
    {
        RoadNetwork network = Star(4, Far);
        var maps = new LaneMaps(new RoadCurves(network), new LaneModel(network));

        Assert.Equal(maps.Whole().Lanes.Count, maps.Around(new Vector3D(Far, 0, 0))!.Lanes.Count);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Junction_of_too_many_roads_is_refused()
    {
        RoadNetwork network = Star(210);
        var maps = new LaneMaps(new RoadCurves(network), new LaneModel(network));

        Assert.Contains("more than 200 roads", Assert.Throws<FormatException>(() => maps.Whole()).Message, StringComparison.Ordinal);
        Assert.Null(maps.Around(Vector3D.Zero));
    }

    [Fact]
    public void Too_many_ways_around_a_place_give_no_map_there()
    {
        RoadNetwork network = Star(100);
        var maps = new LaneMaps(new RoadCurves(network), new LaneModel(network));

        Assert.InRange(maps.Whole().Junctions[0].Ways.Count, 5001, 100 * 99);
        Assert.Null(maps.Around(Vector3D.Zero));
    }

    [Fact]
    public void Map_around_a_place_is_made_in_steps_a_road_or_junction_each()
    {
        RoadNetwork network = Star(4);
        var maps = new LaneMaps(new RoadCurves(network), new LaneModel(network));
        int ticks = 0;
        using (var run = new WorkRun(maps.MakeAround(Vector3D.Zero), () => true))
        {
            while (run.Advance())
            {
                ticks++;
            }
        }

        LaneNetwork made = maps.Around(Vector3D.Zero)!;

        // Four roads and the junction in which they meet.
        Assert.InRange(ticks, 5, 7);
        Assert.Equal(maps.Whole().Lanes.Select(lane => lane.Id), made.Lanes.Select(lane => lane.Id));
        Assert.Same(made, maps.Around(Vector3D.Zero));
        Assert.Empty(maps.MakeAround(Vector3D.Zero));
    }

    [Fact]
    public void Too_many_ways_end_the_steps_without_a_map()
    {
        RoadNetwork network = Star(100);
        var maps = new LaneMaps(new RoadCurves(network), new LaneModel(network));

        WorkRun.Complete(maps.MakeAround(Vector3D.Zero));

        Assert.Null(maps.Around(Vector3D.Zero));
    }

    private static RoadNetwork Star(int arms, double x = 0)
    {
        RoadNode[] nodes =
        [
            .. Enumerable
                .Range(0, arms + 1)
                .Select(i => (Number: i, Angle: 2 * Math.PI * i / arms, Length: i == 0 ? 0 : 5000.0))
                .Select(node => new RoadNode(
                    1,
                    node.Number,
                    new Vector3D(x + (node.Length * Math.Cos(node.Angle)), node.Length * Math.Sin(node.Angle), 0),
                    string.Empty,
                    RoadNodeFlags.None
                )),
        ];
        return new RoadNetwork(nodes, [.. Enumerable.Range(1, arms).Select(i => new RoadLink(0, i, 1, 1, null, RoadLinkFlags.None))]);
    }
}
