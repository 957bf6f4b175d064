using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Maps;

/// <summary>Lights, signs and paint on a crossing of four roads of 60 m with a lane each way, and a road of two lanes each way.</summary>
public sealed class MapContentTests
{
    private const double Arm = 60;
    private const double Width = RoadGeometry.LaneWidth;
    private static readonly Vector3D West = new(-1, 0, 0);

    // The traffic of road 3-0 drives east, south of the road's line.
    private const string Eastbound = "7:3-7:0/f0";

    [Theory]
    [InlineData(-9, -8)]
    [InlineData(9, -8)]
    [InlineData(12, 7)]
    public void Light_that_looks_west_governs_the_lane_to_the_east(double x, double y)
    {
        LaneNetwork map = Crossing(new MapContent { Props = [new MapProp(MapSignalKind.Light, "lamp", new Vector3D(x, y, 0), West)] });

        MapSignal light = Assert.Single(map.Signals);
        Assert.Equal([Eastbound], light.Lanes.Select(lane => lane.Id));
        Assert.Same(light, Assert.Single(map.Find(Eastbound)!.Signals));
        Assert.Equal(light.Lanes, SignalLanes.Of(map, light.Position, light.Facing));
        Assert.Equal(FormattableString.Invariant($"light:{x:0.0},{y:0.0},0.0"), light.Id);
    }

    [Fact]
    public void Sign_beyond_the_junction_governs_nothing()
    {
        LaneNetwork map = Crossing(new MapContent { Props = [new MapProp(MapSignalKind.StopSign, "", new Vector3D(12, -7, 0), West)] });

        Assert.Empty(map.Signals[0].Lanes);
        Assert.Null(map.Signals[0].StopLine);
    }

    [Fact]
    public void Props_at_one_place_or_looking_up_are_left_out()
    {
        var light = new MapProp(MapSignalKind.Light, "", new Vector3D(-9, -8, 0), West);

        LaneNetwork map = Crossing(new MapContent { Props = [light, light, light with { Facing = new Vector3D(0, 0, 1) }] });

        Assert.Single(map.Signals);
    }

    [Fact]
    public void Stop_line_is_derived_where_a_light_holds_lanes_back()
    {
        LaneNetwork map = Crossing(new MapContent { Props = [new MapProp(MapSignalKind.Light, "", new Vector3D(-9, -8, 0), West)] });

        MapStopLine line = Assert.Single(map.StopLines);
        MapLane lane = map.Find(Eastbound)!;
        Assert.Equal(MapSource.Derived, line.Source);
        Assert.Equal((lane.Left[^1], lane.Right[^1]), (line.Left, line.Right));
        Assert.Same(line, lane.StopLine);
        Assert.Same(line, map.Signals[0].StopLine);
    }

    [Fact]
    public void Stop_line_is_derived_from_a_node_that_says_so()
    {
        LaneNetwork map = MapOf(RoadNodeFlags.GiveWay, null);

        Assert.Equal([Eastbound], map.StopLines.SelectMany(line => line.Lanes).Select(lane => lane.Id));
    }

    [Fact]
    public void Painted_stop_line_takes_the_place_of_a_derived_one()
    {
        // A bar of half a metre, 16 m before the middle of the junction, across the lane that leads east.
        var bar = new PaintedMark(MarkKind.StopLine, [new(-16, -5, 0), new(-15.5, -5, 0), new(-15.5, -0.4, 0), new(-16, -0.4, 0)]);

        LaneNetwork map = Crossing(
            new MapContent { Props = [new MapProp(MapSignalKind.Light, "", new Vector3D(-9, -8, 0), West)], KnownMarks = [bar] }
        );

        MapStopLine line = Assert.Single(map.StopLines);
        Assert.Equal(MapSource.Known, line.Source);
        Assert.Equal(new Vector3D(-15.75, -0.4, 0), line.Left);
        Assert.Equal(new Vector3D(-15.75, -5, 0), line.Right);
        Assert.Same(line, map.Signals[0].StopLine);
    }

    [Fact]
    public void Measured_lines_mark_the_edges_that_they_run_along()
    {
        RoadNetwork network = Network(RoadNodeFlags.None);
        var yellow = new MarkingPaint(MarkingStyle.DoubleSolid, MarkingColour.Yellow, 0.3);
        var white = new MarkingPaint(MarkingStyle.Solid, MarkingColour.White, 0.15);
        LinePaint Line(double offset, MarkingPaint paint, double to) =>
            new(0, to, offset, offset, paint) { SigmaMetres = 0.02, Images = 3 };
        var table = new PaintTable(network, [new LinkPaint(2, 0, Arm, [Line(0.2, yellow, Arm), Line(Width - 0.1, white, Arm / 4)])]);

        LaneNetwork map = MapOf(network, new MapContent { Paint = table });

        Assert.Equal(new MapMarking(yellow, MapSource.Measured), map.Find(Eastbound)!.LeftMarking);
        Assert.Equal(yellow, map.Find("7:3-7:0/b0")!.LeftMarking!.Paint);
        Assert.Null(map.Find(Eastbound)!.RightMarking);
        Assert.All(map.Junctions[0].Ways, way => Assert.Null(way.LeftMarking));
    }

    [Fact]
    public void Crossing_is_derived_from_the_link_of_its_ends()
    {
        var network = new RoadNetwork(
            [
                new RoadNode(7, 0, new Vector3D(0, 0, 0), "", RoadNodeFlags.PedestrianCrossing),
                new RoadNode(7, 1, new Vector3D(0, 10, 0), "", RoadNodeFlags.PedestrianCrossing),
                new RoadNode(7, 2, new Vector3D(0, 20, 0), "", RoadNodeFlags.None),
            ],
            [new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None), new RoadLink(1, 2, 1, 1, null, RoadLinkFlags.None)]
        );

        MapCrossing crossing = Assert.Single(MapOf(network, null).Crossings);

        Assert.Equal([new(1.5, 0, 0), new(1.5, 10, 0), new(-1.5, 10, 0), new(-1.5, 0, 0)], crossing.Corners);
        Assert.Equal((MapSource.Derived, "crossing:0.0,5.0,0.0"), (crossing.Source, crossing.Id));
    }

    [Fact]
    public void Speed_sign_limits_the_road_on_whose_right_it_stands()
    {
        LaneNetwork map = Crossing(new MapContent { SpeedSigns = [new MapSpeedSign(15.6, new Vector3D(-40, -8, 0), West)] });

        Assert.Equal([Eastbound], map.Lanes.Where(lane => lane.SpeedLimit == 15.6).Select(lane => lane.Id));
        Assert.All(map.Lanes.Where(lane => lane.Id != Eastbound), lane => Assert.Null(lane.SpeedLimit));
    }

    [Fact]
    public void Area_keeps_whole_roads_and_the_ways_between_them()
    {
        RoadNetwork network = Network(RoadNodeFlags.None);
        var area = new Box2D(-100, -20, 0, 20);

        var map = LaneNetwork.Of(new RoadCurves(network), new LaneModel(network), null, area);

        LaneNetwork whole = Crossing(null);
        Assert.Equal(["7:3-7:0"], map.Segments.Where(segment => segment.Forward[0].Centre[0].X < -30).Select(segment => segment.Id));
        Assert.All(map.Lanes, lane => Assert.Equal(whole.Find(lane.Id)!.Centre, lane.Centre));
        Assert.All(map.Lanes.SelectMany(lane => lane.Successors.Concat(lane.Predecessors)), lane => Assert.Same(lane, map.Find(lane.Id)));
    }

    [Fact]
    public void Lanes_that_begin_are_reached_without_a_jump()
    {
        var network = new RoadNetwork(
            [.. Enumerable.Range(0, 3).Select(i => new RoadNode(7, i, new Vector3D(50 * i, 0, 0), "", RoadNodeFlags.None))],
            [new RoadLink(0, 1, 1, 0, null, RoadLinkFlags.None), new RoadLink(1, 2, 3, 0, null, RoadLinkFlags.None)]
        );

        LaneNetwork map = MapOf(network, null);

        Assert.All(map.Segments[1].Forward, lane => Assert.Equal([map.Segments[0].Forward[0]], lane.Predecessors[0].Predecessors));
        Assert.All(
            map.Lanes.SelectMany(lane => lane.Successors.Select(next => (lane.Left[^1] - next.Left[0]).Length)),
            gap => Assert.Equal(0, gap, 1e-9)
        );
    }

    [Fact]
    public void Index_finds_the_lane_of_a_place_and_direction()
    {
        LaneIndex index = Crossing(null).Index;

        Assert.Equal(Eastbound, index.At(new Vector3D(-30, -1, 0.5), new Vector3D(1, 0.1, 0))?.Id);
        Assert.Null(index.At(new Vector3D(-30, -1, 0.5), new Vector3D(-1, 0, 0)));
        Assert.Null(index.At(new Vector3D(-30, -1, 6), new Vector3D(1, 0, 0)));
        Assert.Null(index.At(new Vector3D(-30, -Width - 0.1, 0), new Vector3D(1, 0, 0)));
        Assert.Equal(Eastbound + ">7:1-7:0/b0", index.At(new Vector3D(0, -Width / 2, 0), new Vector3D(1, 0, 0))?.Id);
    }

    [Fact]
    public void Index_finds_the_lanes_within_a_range()
    {
        LaneIndex index = Crossing(null).Index;

        Assert.Equal([Eastbound, "7:3-7:0/b0"], index.Near(new Vector3D(-40, -1, 0), 3).Select(lane => lane.Id));
        Assert.Equal([Eastbound], index.Near(new Vector3D(-40, -Width - 2, 0), 3).Select(lane => lane.Id));
        Assert.Empty(index.Near(new Vector3D(-40, -Width - 4, 0), 3));
    }

    private static LaneNetwork Crossing(MapContent? content) => MapOf(RoadNodeFlags.None, content);

    private static LaneNetwork MapOf(RoadNodeFlags flagsOfWest, MapContent? content) => MapOf(Network(flagsOfWest), content);

    private static RoadNetwork Network(RoadNodeFlags flagsOfWest)
    {
        Vector3D[] nodes = [new(0, 0, 0), new(Arm, 0, 0), new(0, Arm, 0), new(-Arm, 0, 0), new(0, -Arm, 0)];
        return new RoadNetwork(
            [.. nodes.Select((place, number) => new RoadNode(7, number, place, "", number == 3 ? flagsOfWest : RoadNodeFlags.None))],
            [.. Enumerable.Range(1, 4).Select(from => new RoadLink(from, 0, 1, 1, null, RoadLinkFlags.None))]
        );
    }

    private static LaneNetwork MapOf(RoadNetwork network, MapContent? content) =>
        LaneNetwork.Of(new RoadCurves(network), new LaneModel(network), content);
}
