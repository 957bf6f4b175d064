using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Paint;

public sealed class PlacedPaintTests
{
    private static readonly MarkingPaint White = new(MarkingStyle.Solid, MarkingColour.White, 0.15);

    /// <summary>Three links of 40 m to the north; the middle one runs south.</summary>
    private static readonly RoadNetwork Road = new(
        [.. Enumerable.Range(0, 4).Select(i => new RoadNode(0, i, new Vector3D(0, i * 40, 0), "", RoadNodeFlags.None))],
        [
            new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None),
            new RoadLink(2, 1, 1, 1, null, RoadLinkFlags.None),
            new RoadLink(2, 3, 1, 1, null, RoadLinkFlags.None),
        ]
    );

    [Fact]
    public void Stretches_that_continue_each_other_are_one_line()
    {
        PaintedLine line = Assert.Single(new PlacedPaint(Table()).Near(new Vector3D(0, 60, 0), 100));

        Assert.Equal(0.04, line.SigmaMetres);
        double[] ys = [.. line.Points.Select(point => point.World.Y)];
        Assert.Equal((0, 120), (Math.Round(ys.Min(), 6), Math.Round(ys.Max(), 6)));
        Assert.True(ys.SequenceEqual(ys.Order()) || ys.SequenceEqual(ys.OrderDescending()));
        Assert.All(line.Points, point => Assert.InRange(point.World.X, 3 - 1e-6, 3.2 + 1e-6));
        Assert.Equal(ys.Length, ys.Distinct().Count());
    }

    [Fact]
    public void Only_what_is_near_is_placed()
    {
        var paint = new PlacedPaint(Table());

        Assert.Empty(paint.Near(new Vector3D(500, 60, 0), 100));
        PaintedLine line = Assert.Single(paint.Near(new Vector3D(3, 0, 0), 10));
        Assert.InRange(line.Points.Max(point => point.World.Y), 10, 80);
    }

    [Fact]
    public void Other_paint_does_not_continue_a_line()
    {
        LinePaint yellow = Line(0, 40, 3.2, 3.2) with { Paint = White with { Colour = MarkingColour.Yellow } };
        var table = new PaintTable(Road, [new LinkPaint(0, 0, 40, [Line(0, 40, 3.2, 3.2)]), new LinkPaint(2, 0, 40, [yellow])]);

        Assert.Equal(2, new PlacedPaint(table).Near(new Vector3D(0, 60, 0), 100).Count());
    }

    private static PaintTable Table() =>
        new(
            Road,
            [
                new LinkPaint(0, 0, 40, [Line(0, 25, 3, 3.2), Line(25, 40, 3.2, 3.2) with { SigmaMetres = 0.04 }]),
                new LinkPaint(1, 0, 40, [Line(0, 40, -3.2, -3.2)]),
                new LinkPaint(2, 0, 40, [Line(0, 40, 3.2, 3.2)]),
            ]
        );

    private static LinePaint Line(double from, double to, double fromOffset, double toOffset) =>
        new(from, to, fromOffset, toOffset, White) { SigmaMetres = 0.02, Images = 5 };
}
