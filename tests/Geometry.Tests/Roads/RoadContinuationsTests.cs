using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Roads;

public sealed class RoadContinuationsTests
{
    private static readonly (double X, double Y) Middle = (0, 0);

    [Fact]
    public void At_a_side_road_the_main_road_continues_and_the_other_ends()
    {
        RoadContinuations continuations = Star((1, 1), (0, -20), (0, 20), (20, 2));

        Assert.Equal(1, continuations.Of(0, beyondEnd: false));
        Assert.Equal(0, continuations.Of(1, beyondEnd: false));
        Assert.Equal(RoadContinuations.None, continuations.Of(2, beyondEnd: false));
        Assert.Equal(RoadContinuations.None, continuations.Of(0, beyondEnd: true));
    }

    [Fact]
    public void At_a_crossing_both_roads_continue_straight()
    {
        RoadContinuations continuations = Star((1, 1), (0, -20), (-20, 0), (0, 20), (20, 0));

        Assert.Equal([2, 3, 0, 1], Enumerable.Range(0, 4).Select(link => continuations.Of(link, beyondEnd: false)));
    }

    [Fact]
    public void Sharp_bend_of_two_links_continues_but_a_u_turn_does_not()
    {
        Assert.Equal(1, Star((1, 1), (0, -20), (20, 0)).Of(0, beyondEnd: false));
        // From the south and back to the south-south-east: a bend of 166 degrees.
        Assert.Equal(RoadContinuations.None, Star((1, 1), (0, -20), (5, -20)).Of(0, beyondEnd: false));
    }

    [Fact]
    public void Two_one_way_roads_that_meet_head_on_do_not_continue() =>
        Assert.Equal(RoadContinuations.None, Star((1, 0), (0, -20), (0, 20)).Of(0, beyondEnd: false));

    /// <summary>Links from a node in the middle to others, all with the same lanes outwards and inwards.</summary>
    private static RoadContinuations Star((int Outwards, int Inwards) lanes, params (double X, double Y)[] ends)
    {
        RoadNode[] nodes =
        [
            .. ends.Prepend(Middle).Select((end, i) => new RoadNode(0, i, new Vector3D(end.X, end.Y, 0), "", RoadNodeFlags.None)),
        ];
        return new RoadContinuations(
            new RoadNetwork(
                nodes,
                [.. ends.Select((_, i) => new RoadLink(0, i + 1, lanes.Outwards, lanes.Inwards, null, RoadLinkFlags.None))]
            )
        );
    }
}
