using Harvester.Driving.Scenarios;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenarios;

namespace Harvester.Driving.Tests.Scenarios;

public sealed class ScenarioBinderTests
{
    private const string Overtaking = """
        {"name":"s","kind":"k","place":{"metres":60,"straightMetres":40,"lanesLeft":1},
        "actors":[{"id":"a","type":"vehicle","start":{"metresAhead":-30}}]}
        """;

    [Theory]
    [InlineData(2, 2, 100, 40, null)]
    [InlineData(2, 1, 100, 40, null)]
    [InlineData(2, 1, 170, 60, "The road bends ")]
    [InlineData(1, 2, 210, 60, "A lane beside the ego's ends ")]
    [InlineData(1, 2, 260, 40, null)]
    public void Lanes_beside_the_ego_are_there_from_the_hindmost_actor_on(
        int lanesBefore,
        int lanesAfter,
        double metresFromStart,
        double metres,
        string? reason
    )
    {
        string text = Overtaking.Replace("\"straightMetres\":40", FormattableString.Invariant($"\"straightMetres\":{metres}"));

        // The lane on the right of a road to the north: two lanes of 5.5 m, or one.
        BoundScenario? bound = ScenarioBinder.BindNear(
            ScenarioParser.Read(text).Template!.Middle,
            Map(lanesBefore, lanesAfter),
            new Vector2D(RoadGeometry.LaneWidth * 1.5, metresFromStart),
            headingDegrees: 0,
            seed: 1,
            out string? why
        );

        Assert.Equal(reason is null, bound is not null);
        Assert.StartsWith(reason ?? "", why ?? "", StringComparison.Ordinal);
    }

    [Fact]
    public void Who_comes_from_the_side_is_on_the_line_before_the_ego()
    {
        const double speed = 8;
        const double earlier = 1;
        const double egoStart = -50;

        // Within a piece of the search, of 0.5 m, a way that bends lies beside the straight line through its ends.
        const double searched = 0.01;
        const string text = """
            {"name":"s","kind":"k","ego":{"speed":8},"place":{"metres":60,"junction":{"within":[10,60],"approaches":["right"]}},
            "actors":[{"id":"a","type":"vehicle","start":{"approach":"right","secondsBefore":1},"speed":8}],
            "events":[{"id":"e","actor":"a","do":{"action":"runJunction","turn":"straight"}}]}
            """;

        // A road to the north, and one that comes to it from behind on the right.
        var roads = new RoadNetwork(
            [
                new RoadNode(0, 0, new Vector3D(0, 0, 0), "", RoadNodeFlags.None),
                new RoadNode(0, 1, new Vector3D(0, -200, 0), "", RoadNodeFlags.None),
                new RoadNode(0, 2, new Vector3D(0, 200, 0), "", RoadNodeFlags.None),
                new RoadNode(0, 3, new Vector3D(200, -120, 0), "", RoadNodeFlags.None),
                new RoadNode(0, 4, new Vector3D(-200, 120, 0), "", RoadNodeFlags.None),
            ],
            [
                new RoadLink(1, 0, 1, 1, null, RoadLinkFlags.None),
                new RoadLink(0, 2, 1, 1, null, RoadLinkFlags.None),
                new RoadLink(3, 0, 1, 1, null, RoadLinkFlags.None),
                new RoadLink(0, 4, 1, 1, null, RoadLinkFlags.None),
            ]
        );
        LaneNetwork map = LaneNetwork.Of(new RoadCurves(roads), new LaneModel(roads), MapContent.None);
        var near = new Vector2D(RoadGeometry.LaneWidth / 2, egoStart);
        BoundScenario? bound = ScenarioBinder.BindNear(
            ScenarioParser.Read(text).Template!.Middle,
            map,
            near,
            headingDegrees: 0,
            seed: 1,
            out string? why
        );

        Assert.Null(why);
        LaneTrack track = bound!.Actors[0].Track;
        double at = Enumerable.Range(0, 20_000).Select(i => i * 0.01).First(metres => track.PositionAt(metres).X <= near.X);
        double egoSeconds = (track.PositionAt(at).Y - bound.Ego.Y) / speed;
        Assert.Equal(egoSeconds - earlier, at / speed, searched);
    }

    /// <summary>A straight road to the north of 200 m and another 200 m, with numbers of lanes to the north.</summary>
    private static LaneNetwork Map(int lanesBefore, int lanesAfter)
    {
        var roads = new RoadNetwork(
            [
                new RoadNode(0, 0, new Vector3D(0, 0, 0), "", RoadNodeFlags.None),
                new RoadNode(0, 1, new Vector3D(0, 200, 0), "", RoadNodeFlags.None),
                new RoadNode(0, 2, new Vector3D(0, 400, 0), "", RoadNodeFlags.None),
            ],
            [new RoadLink(0, 1, lanesBefore, 1, null, RoadLinkFlags.None), new RoadLink(1, 2, lanesAfter, 1, null, RoadLinkFlags.None)]
        );
        return LaneNetwork.Of(new RoadCurves(roads), new LaneModel(roads), MapContent.None);
    }
}
