using FsCheck;
using FsCheck.Fluent;
using Harvester.Geometry.Boxes;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.Boxes;

public sealed class ConvexPolygonTests
{
    private static readonly Vector2D[] Square = [new(0, 0), new(2, 0), new(2, 2), new(0, 2)];

    [Fact]
    public void Hull_drops_points_inside_and_on_the_edges()
    {
        IReadOnlyList<Vector2D> hull = ConvexPolygon.Hull([new(1, 1), new(2, 0), new(0, 0), new(1, 0), new(2, 2), new(0, 2), new(0, 0)]);

        Assert.Equal(Square, hull);
    }

    [Fact]
    public void Hull_does_not_depend_on_the_order_of_points() =>
        RandomCases.Check(
            200,
            Arb.Zip(Points(12, 5), RandomCases.Integer(0, 1_000)),
            drawn =>
            {
                Vector2D[] points = [.. drawn.Item1];
                IReadOnlyList<Vector2D> hull = ConvexPolygon.Hull(points);
                new Random(drawn.Item2).Shuffle(points);

                Assert.Equal(hull, ConvexPolygon.Hull(points));
            }
        );

    [Fact]
    public void Hull_contains_every_point_and_turns_left_everywhere() =>
        RandomCases.Check(
            200,
            Points(15, 49),
            points =>
            {
                IReadOnlyList<Vector2D> hull = ConvexPolygon.Hull(points);

                Assert.All(points, point => Assert.True(ConvexPolygon.Contains(hull, point)));
                for (int k = 0; k < hull.Count; k++)
                {
                    Vector2D side = hull[(k + 1) % hull.Count] - hull[k];
                    Assert.True(side.Cross(hull[(k + 2) % hull.Count] - hull[(k + 1) % hull.Count]) > 0);
                }
            }
        );

    [Fact]
    public void Hull_degenerate_input_has_no_area()
    {
        Assert.Empty(ConvexPolygon.Hull([]));
        Assert.Equal([new(1, 1)], ConvexPolygon.Hull([new(1, 1), new(1, 1), new(1, 1)]));
        Assert.Equal([new(1, 1)], ConvexPolygon.Hull([new(1, 1), new(1, 1)]));
        Assert.Equal([new(0, 0), new(3, 3)], ConvexPolygon.Hull([new(1, 1), new(3, 3), new(0, 0), new(2, 2)]));
    }

    [Fact]
    public void Area_does_not_depend_on_winding_or_first_corner()
    {
        // 3-4-5 triangle: 6.
        Vector2D[] triangle = [new(1e6, 1e6), new(1e6 + 3, 1e6), new(1e6, 1e6 + 4)];

        Assert.Equal(6, ConvexPolygon.Area(triangle));
        Assert.Equal(6, ConvexPolygon.Area([triangle[2], triangle[1], triangle[0]]));
        Assert.Equal(6, ConvexPolygon.Area([triangle[1], triangle[2], triangle[0]]));
        Assert.Equal(0, ConvexPolygon.Area([triangle[0], triangle[1]]));
        Assert.Equal(0, ConvexPolygon.Area([]));
    }

    [Fact]
    public void Clip_corner_of_a_diamond_leaves_a_triangle()
    {
        // The diamond |x| + |y| <= 2 in the box x >= 1, all y: the triangle (1,-1), (2,0), (1,1), area 1.
        IReadOnlyList<Vector2D> clipped = ConvexPolygon.Clip([new(-2, 0), new(0, -2), new(2, 0), new(0, 2)], new Box2D(1, -9, 9, 9));

        Assert.Equal(3, clipped.Count);
        Assert.Equal(1, ConvexPolygon.Area(clipped), 1e-12);
    }

    [Fact]
    public void Clip_to_boxes_around_beside_and_inside_the_polygon()
    {
        Assert.Equal(Square, ConvexPolygon.Clip(Square, new Box2D(-1, -1, 3, 3)));
        Assert.Empty(ConvexPolygon.Clip(Square, new Box2D(5, 5, 6, 6)));
        Assert.Equal(0.25, ConvexPolygon.Area(ConvexPolygon.Clip(Square, new Box2D(1, 1, 1.5, 1.5))));
        Assert.Empty(ConvexPolygon.Clip([], new Box2D(0, 0, 1, 1)));
    }

    [Fact]
    public void Clip_area_agrees_with_counted_points()
    {
        RandomCases.Check(
            20,
            RandomCases.ArrayOf(Draws.Pixels(100, 100), 8),
            points =>
            {
                IReadOnlyList<Vector2D> hull = ConvexPolygon.Hull(points);
                var box = new Box2D(20, 30, 80, 70);
                const int steps = 200;
                int inside = 0;
                for (int k = 0; k < steps * steps; k++)
                {
                    var point = new Vector2D(20 + ((k % steps + 0.5) * 60 / steps), 30 + ((k / steps + 0.5) * 40 / steps));
                    inside += ConvexPolygon.Contains(hull, point) ? 1 : 0;
                }

                // Only cells along the outline can be miscounted, about one per step and side: 1 % of 2,400.
                Assert.Equal(inside * 2400.0 / (steps * steps), ConvexPolygon.Area(ConvexPolygon.Clip(hull, box)), 24.0);
            }
        );
    }

    [Fact]
    public void Contains_includes_sides_and_accepts_either_winding()
    {
        Assert.True(ConvexPolygon.Contains(Square, new(1, 1)));
        Assert.True(ConvexPolygon.Contains(Square, new(2, 1)));
        Assert.True(ConvexPolygon.Contains(Square, new(0, 0)));
        Assert.False(ConvexPolygon.Contains(Square, new(3, 0)));
        Assert.False(ConvexPolygon.Contains(Square, new(2.0001, 1)));
        Assert.True(ConvexPolygon.Contains([.. Square.Reverse()], new(1, 1)));
        Assert.False(ConvexPolygon.Contains([new(0, 0), new(2, 0)], new(1, 0)));
        Assert.False(ConvexPolygon.Contains([], new(1, 0)));
    }

    [Fact]
    public void Bounds_surround_the_points()
    {
        Assert.Equal(new Box2D(-1, 2, 3, 8), ConvexPolygon.Bounds([new(3, 2), new(-1, 8)]));
        Assert.Null(ConvexPolygon.Bounds([]));
    }

    private static Arbitrary<Vector2D[]> Points(int count, int max) =>
        RandomCases.ArrayOf(
            Arb.Convert(
                Arb.Zip(RandomCases.Integer(0, max), RandomCases.Integer(0, max)),
                at => new Vector2D(at.Item1, at.Item2),
                point => ((int)point.X, (int)point.Y)
            ),
            count
        );
}
