using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Paint;

public sealed class PaintedSectionsTests
{
    private static readonly MarkingPaint White = new(MarkingStyle.Solid, MarkingColour.White, 0.15);
    private static readonly MarkingPaint Yellow = new(MarkingStyle.Solid, MarkingColour.Yellow, 0.15);
    private static readonly MarkingPaint Dashed = new(MarkingStyle.Dashed, MarkingColour.White, 0.15);

    [Fact]
    public void Freeway_has_the_lanes_between_its_lines()
    {
        // The yellow edge, the dashes and the white edge lie 6.1 m apart.
        MeasuredSection section = Sections(2, 0, (-6.3, Yellow), (-0.2, Dashed), (5.9, White))[(0, true)];

        Assert.Equal(-6.3, section.LeftEdge, 9);
        Assert.Equal(6.1, section.Section.LaneWidth, 9);
    }

    [Fact]
    public void Directions_share_the_line_between_them()
    {
        Dictionary<(int, bool), MeasuredSection> sections = Sections(1, 1, (-3.5, White), (0.2, Dashed), (4.2, White));

        // Backward, the same lines lie at -4.2, -0.2 and 3.5.
        Assert.Equal((0.2, 4), Rounded(sections[(0, true)]));
        Assert.Equal((-0.2, 3.7), Rounded(sections[(0, false)]));
    }

    [Fact]
    public void Two_boundaries_suffice()
    {
        // Three lanes between the edges: (6 - -4.5) / 3 = 3.5. Two dashed lines lie between three lanes; of one it is unclear which it is.
        Assert.Equal((-4.5, 3.5), Rounded(Sections(3, 0, (-4.5, White), (6, White))[(0, true)]));
        Assert.Equal((-4.5, 3.5), Rounded(Sections(3, 0, (-1, Dashed), (2.5, Dashed))[(0, true)]));
        Assert.Empty(Sections(3, 0, (-1, Dashed)));
        Assert.Equal((-4.5, 3.5), Rounded(Sections(3, 0, (-4.5, Yellow), (-1, Dashed), (6, White))[(0, true)]));
    }

    [Fact]
    public void Each_lane_lies_between_its_own_lines()
    {
        // Lanes of 3.4, 3.7 and 3 m; backward, with a median, of 3.1 and 3.3 m.
        MeasuredSection oneWay = Sections(3, 0, (-5, Yellow), (-1.6, Dashed), (2.1, Dashed), (5.1, White))[(0, true)];
        Assert.Equal([3.4, 3.7, 3], oneWay.Section.LaneWidths!.Select(width => Math.Round(width, 9)));

        Dictionary<(int, bool), MeasuredSection> sections = Sections(
            1,
            2,
            (-8.4, White),
            (-5.1, Dashed),
            (-2, Yellow),
            (2, Yellow),
            (5.5, White)
        );
        Assert.Equal((2, 3.5), Rounded(sections[(0, true)]));
        Assert.Equal(2, sections[(0, false)].LeftEdge, 9);
        Assert.Equal([3.1, 3.3], sections[(0, false)].Section.LaneWidths!.Select(width => Math.Round(width, 9)));
    }

    [Fact]
    public void Unpainted_edge_is_a_mean_lane_beyond_the_last_line()
    {
        // The right edge is not painted: (2.5 - -4.5) / 2 = 3.5 beyond 2.5.
        MeasuredSection section = Sections(3, 0, (-4.5, Yellow), (-1.2, Dashed), (2.5, Dashed))[(0, true)];

        Assert.Equal([3.3, 3.7, 3.5], section.Section.LaneWidths!.Select(width => Math.Round(width, 9)));
    }

    [Fact]
    public void Edge_that_is_not_seen_is_that_of_the_next_link()
    {
        // Links 0 and 1 are one road of two lanes one way, which ends at a junction of link 1 with links 2 and 3.
        RoadNode[] nodes =
        [
            .. new[] { (0, 0), (0, 40), (0, 80), (0, 120), (40, 80) }.Select(
                (place, i) => new RoadNode(0, i, new Vector3D(place.Item1, place.Item2, 0), "", RoadNodeFlags.None)
            ),
        ];
        RoadLink Link(int from, int to) => new(from, to, 2, 0, null, RoadLinkFlags.None);
        var network = new RoadNetwork(nodes, [Link(0, 1), Link(1, 2), Link(2, 3), Link(2, 4)]);
        var table = new PaintTable(
            network,
            [Painted(0, (-3.5, Yellow), (0.1, Dashed), (3.1, White)), Painted(1, (-3.5, Yellow), (0.1, Dashed))]
        );

        IReadOnlyDictionary<(int Link, bool), MeasuredLanes> lanes = PaintedSections.Of(table, new RoadCurves(network));

        Assert.Equal([0, 1], lanes.Keys.Select(key => key.Link).Order());
        Assert.Equal([3.6, 3], lanes[(1, true)].At(20).Section.LaneWidths!.Select(width => Math.Round(width, 9)));
        Assert.True(lanes[(1, true)].At(20).IsWhole);
    }

    [Fact]
    public void Lanes_of_unpainted_links_are_partly_those_of_paint()
    {
        RoadNode[] nodes = [.. Enumerable.Range(0, 3).Select(i => new RoadNode(0, i, new Vector3D(0, i * 40, 0), "", RoadNodeFlags.None))];
        var network = new RoadNetwork(
            nodes,
            [new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None), new RoadLink(2, 1, 1, 1, null, RoadLinkFlags.None)]
        );
        var table = new PaintTable(network, [Painted(0, (-3.5, White), (0.2, Dashed), (4.2, White))]);

        var model = new LaneModel(network, measured: PaintedSections.Of(table, new RoadCurves(table.Network)));

        Assert.Equal((4, LaneWidthSource.Paint), Rounded(model.WidthOf(0, isForward: true, station: 20)));

        // Link 1 runs the other way.
        Assert.Equal((4, LaneWidthSource.PartlyPaint), Rounded(model.WidthOf(1, isForward: false, station: 20)));
        Assert.Equal((3.7, LaneWidthSource.PartlyPaint), Rounded(model.WidthOf(1, isForward: true, station: 20)));
    }

    [Fact]
    public void Link_without_a_length_has_the_lanes_of_its_neighbours()
    {
        RoadNode[] nodes =
        [
            .. new double[] { 0, 40, 40, 80 }.Select((y, i) => new RoadNode(0, i, new Vector3D(0, y, i), string.Empty, RoadNodeFlags.None)),
        ];
        var network = new RoadNetwork(
            nodes,
            [.. Enumerable.Range(0, 3).Select(i => new RoadLink(i, i + 1, 1, 1, null, RoadLinkFlags.None))]
        );
        var table = new PaintTable(network, [Painted(0, (-3.5, White), (0.2, Dashed), (4.2, White))]);

        IReadOnlyDictionary<(int Link, bool), MeasuredLanes> lanes = PaintedSections.Of(table, new RoadCurves(network));

        Assert.Equal(4, lanes[(0, true)].At(20).Section.LaneWidth, 9);
        Assert.All(lanes.Values, each => Assert.True(double.IsFinite(each.At(0).LeftEdge)));
    }

    [Fact]
    public void Boundaries_follow_their_lines_along_the_link()
    {
        // The edge moves from 3.5 to 3.9 m, 1 cm a metre; the line between the directions stays.
        var edge = new LinePaint(0, 40, 3.5, 3.9, White) { SigmaMetres = 0.02, Images = 5 };
        var centre = new LinePaint(0, 40, 0, 0, Dashed) { SigmaMetres = 0.02, Images = 5 };
        MeasuredLanes lanes = Lanes(new LinkPaint(0, 0, 40, [centre, edge]));

        foreach (double station in new double[] { 0, 7, 20, 33.3, 40 })
        {
            Assert.Equal(3.5 + (0.01 * station), lanes.At(station).LeftEdge + lanes.At(station).Section.Width, 6);
        }
    }

    [Fact]
    public void Boundary_that_was_not_seen_moves_with_those_that_were()
    {
        // Between the stations 0 and 40 the line between the directions moves by 0.4 m, as where a bend is not that of the link's curve.
        // The edge was only seen up to 12: from there it keeps its distance of 3.5 m from that line.
        var edge = new LinePaint(0, 12, 3.5, 3.62, White) { SigmaMetres = 0.02, Images = 5 };
        var centre = new LinePaint(0, 40, 0, 0.4, Dashed) { SigmaMetres = 0.02, Images = 5 };
        MeasuredLanes lanes = Lanes(new LinkPaint(0, 0, 40, [centre, edge]));

        Assert.Equal(3.5, lanes.At(30).Section.LaneWidth, 6);
        Assert.True(lanes.At(30).IsWhole);
    }

    [Fact]
    public void Lane_of_one_boundary_is_as_wide_as_the_oncoming_one()
    {
        // The right edge is not painted; backward, the lane is 3.7 m wide.
        Dictionary<(int, bool), MeasuredSection> sections = Sections(1, 1, (-3.5, White), (0.2, Dashed));

        Assert.Equal((0.2, 3.7), Rounded(sections[(0, true)]));
        Assert.False(sections[(0, true)].IsWhole);
        Assert.True(sections[(0, false)].IsWhole);
    }

    [Fact]
    public void Lines_that_are_not_the_edges_of_lanes_give_none()
    {
        Assert.Empty(Sections(2, 0, (-5.4, White)));
        Assert.Empty(Sections(2, 0, (-5.4, White), (1.7, Dashed), (5.4, White)));
        Assert.Empty(Sections(2, 0, (-2, White), (2, White)));
        Assert.Empty(Sections(1, 0, (-4, White), (4, White)));
    }

    [Fact]
    public void Model_takes_measured_lanes_before_constants()
    {
        PaintTable table = Table(2, 0, (-6.3, Yellow), (-0.2, Dashed), (5.9, White));
        var model = new LaneModel(table.Network, measured: PaintedSections.Of(table, new RoadCurves(table.Network)));

        Assert.Equal(6.1, model.WidthOf(0, isForward: true, station: 20).Width, 9);
        Assert.Equal(LaneWidthSource.Paint, model.WidthOf(0, isForward: true, station: 20).Source);
        Assert.Equal(-6.3, model.LanesOf(0, isForward: true, station: 20)!.Value.LeftEdge, 9);
        Assert.Equal(LaneWidthSource.Constant, new LaneModel(table.Network).WidthOf(0, isForward: true, station: 20).Source);
    }

    private static (double LeftEdge, double LaneWidth) Rounded(MeasuredSection section) =>
        (Math.Round(section.LeftEdge, 9), Math.Round(section.Section.LaneWidth, 9));

    private static (double Width, LaneWidthSource Source) Rounded((double Width, LaneWidthSource Source) width) =>
        (Math.Round(width.Width, 9), width.Source);

    private static Dictionary<(int Link, bool IsForward), MeasuredSection> Sections(
        int lanesForward,
        int lanesBackward,
        params (double Offset, MarkingPaint Paint)[] lines
    )
    {
        PaintTable table = Table(lanesForward, lanesBackward, lines);
        return PaintedSections.Of(table, new RoadCurves(table.Network)).ToDictionary(lanes => lanes.Key, lanes => lanes.Value.At(20));
    }

    /// <summary>The forward lanes of a road of one lane each way.</summary>
    private static MeasuredLanes Lanes(LinkPaint paint)
    {
        RoadNetwork network = Table(1, 1).Network;
        return PaintedSections.Of(new PaintTable(network, [paint]), new RoadCurves(network))[(0, true)];
    }

    private static PaintTable Table(int lanesForward, int lanesBackward, params (double Offset, MarkingPaint Paint)[] lines)
    {
        var network = new RoadNetwork(
            [.. Enumerable.Range(0, 2).Select(i => new RoadNode(0, i, new Vector3D(0, i * 40, 0), "", RoadNodeFlags.None))],
            [new RoadLink(0, 1, lanesForward, lanesBackward, null, RoadLinkFlags.None)]
        );
        return new PaintTable(network, [Painted(0, lines)]);
    }

    private static LinkPaint Painted(int link, params (double Offset, MarkingPaint Paint)[] lines) =>
        new(
            link,
            0,
            40,
            [.. lines.Select(line => new LinePaint(0, 40, line.Offset, line.Offset, line.Paint) { SigmaMetres = 0.02, Images = 5 })]
        );
}
