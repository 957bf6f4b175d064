using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Lanes;

public sealed class PaintTracerTests
{
    private static readonly AnalyticRoad Straight = new((0, 200));
    private static readonly MarkingPaint White = new(MarkingStyle.Dashed, MarkingColour.White, 0.15);

    [Fact]
    public void Paint_gets_the_number_of_the_nearest_boundary_and_stays_put()
    {
        // Two lanes from 0 to 10.8 m right of the line; an edge is painted 0.25 m inside.
        IReadOnlyList<LaneLine> lines = Trace(Line(10.55, 20, 90), Line(5.4, 20, 90), Line(0.1, 20, 90));

        Assert.Equal([0, 1, 2], lines.Select(line => line.Index));
        Assert.Equal([true, false, false], lines.Select(line => line.IsLeftOfCar));
        Assert.All(lines[2].Points, point => Assert.Equal(10.55, point.World.X, 9));
        Assert.All(lines, line => Assert.Equal(White, line.Paint));
    }

    [Fact]
    public void Line_begins_at_the_car_and_ends_where_the_paint_ends()
    {
        LaneLine line = Assert.Single(Trace(Line(5.4, 10, 70)));

        // The car is at 50 m; points are half a metre apart there, and the last is the paint's own.
        Assert.InRange(line.Points[0].World.Y, 50, 50.5);
        Assert.Equal(70, line.Points[^1].World.Y, 9);
    }

    [Fact]
    public void Paint_in_the_opposite_direction_is_reversed()
    {
        LaneLine line = Assert.Single(Trace(Line(5.4, 90, 40)));

        Assert.True(line.Points[0].World.Y < line.Points[^1].World.Y);
    }

    [Fact]
    public void Gaps_of_a_dashed_line_are_not_painted()
    {
        var dashed = new PaintedLine(
            White,
            [.. Enumerable.Range(0, 100).Select(i => new LinePoint(new Vector3D(5.4, 50.25 + (i * 0.5), 0), i / 6 % 3 == 0))]
        );

        Assert.All(
            Assert.Single(Trace(dashed)).Points,
            point => Assert.Equal((int)((point.World.Y - 50.25) / 3) % 3 == 0, point.IsPainted)
        );
    }

    [Fact]
    public void Paint_that_marks_no_boundary_or_crosses_it_is_omitted()
    {
        var across = new PaintedLine(White, [.. Enumerable.Range(0, 40).Select(i => new LinePoint(new Vector3D(i * 0.5, 80, 0), true))]);

        Assert.Empty(Trace(Line(2.7, 20, 90), Line(30, 20, 90), across));
    }

    private static IReadOnlyList<LaneLine> Trace(params PaintedLine[] paint)
    {
        RoadNetwork network = Straight.Network(5, 2, 1);
        LaneObservation seen = new LaneObserver(new RoadCurves(network), new LaneModel(network)).Observe(
            Straight.At(50, 2.7).Point,
            0,
            10,
            4,
            [],
            null
        );
        return PaintTracer.Trace(seen.Stretch!, 2.7, 0, 60, paint);
    }

    /// <summary>A line beside the road's, with a point every half metre.</summary>
    private static PaintedLine Line(double right, double from, double to)
    {
        int steps = (int)(Math.Abs(to - from) * 2);
        return new PaintedLine(
            White,
            [.. Enumerable.Range(0, steps + 1).Select(i => new LinePoint(Straight.At(from + ((to - from) * i / steps), right).Point, true))]
        );
    }
}
