using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;

namespace Harvester.Geometry.Tests.Paint;

public sealed class PaintDoublesTests
{
    private const int Rows = 120;

    [Fact]
    public void Double_line_of_a_broken_stripe_has_one_middle()
    {
        // The left stripe at -0.15 m was found in two pieces, the right one at 0.15 m as a whole.
        FoundLine line = Assert.Single(PaintDoubles.Joined([Line(-0.15, 0, 16), Line(0.15, 0, Rows), Line(-0.15, 40, Rows)]));

        Assert.Equal(MarkingStyle.DoubleSolid, line.Paint.Style);
        Assert.Equal(0.45, line.Paint.WidthMetres, 9);
        Assert.Equal(Rows, line.Stripes.Count);
        Assert.All(line.Stripes, stripe => Assert.Equal(0, stripe.Offset, 9));
    }

    [Fact]
    public void Lines_of_other_colours_or_farther_apart_are_single()
    {
        Assert.Equal(2, PaintDoubles.Joined([Line(0, 0, Rows), Line(0.3, 0, Rows, MarkingColour.White)]).Count);
        Assert.Equal(2, PaintDoubles.Joined([Line(0, 0, Rows), Line(0.8, 0, Rows)]).Count);
        Assert.Equal(2, PaintDoubles.Joined([Line(0, 0, 40), Line(0.3, 50, Rows)]).Count);
    }

    [Fact]
    public void Third_stripe_beside_a_double_line_is_single()
    {
        Assert.Equal(
            [MarkingStyle.DoubleSolid, MarkingStyle.Solid],
            PaintDoubles.Joined([Line(0, 0, Rows), Line(0.3, 0, Rows), Line(0.6, 2, Rows)]).Select(line => line.Paint.Style)
        );
    }

    private static FoundLine Line(double offset, int from, int to, MarkingColour colour = MarkingColour.Yellow) =>
        new(
            from * PaintRow.Length,
            to * PaintRow.Length,
            [
                .. Enumerable
                    .Range(from, to - from)
                    .Select(row => new StripeCluster(row, (row + 0.5) * PaintRow.Length, offset, 0.15, 1, 0.4, 0.05, 2)),
            ],
            new MarkingPaint(MarkingStyle.Solid, colour, 0.15),
            1
        );
}
