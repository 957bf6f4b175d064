namespace Harvester.Geometry.Tests;

public sealed class Box2DTests
{
    private static readonly Box2D Left = new(0, 0, 4, 2);
    private static readonly Box2D Right = new(3, 1, 6, 5);

    [Fact]
    public void Intersect_overlapping_boxes_share_a_unit_square()
    {
        // Shared: x 3..4, y 1..2 = 1; union 8 + 12 - 1 = 19.
        Assert.Equal(new Box2D(3, 1, 4, 2), Left.Intersect(Right));
        Assert.Equal(1.0 / 19, Left.IntersectionOverUnion(Right), 1e-15);
        Assert.Equal(new Box2D(0, 0, 6, 5), Left.Union(Right));
    }

    [Fact]
    public void Intersect_touching_boxes_share_nothing()
    {
        Assert.Null(Left.Intersect(new Box2D(4, 0, 5, 2)));
        Assert.Equal(0, Left.IntersectionOverUnion(new Box2D(4, 0, 5, 2)));
    }

    [Fact]
    public void Contains_sides_of_a_point_are_half_open()
    {
        Assert.True(Left.Contains(new Vector2D(0, 0)));
        Assert.False(Left.Contains(new Vector2D(4, 1)));
        Assert.True(Left.Contains(Left));
        Assert.False(Left.Contains(new Box2D(-0.1, 0, 4, 2)));
        Assert.True(Left.Contains(new Box2D(-0.1, 0, 4, 2), margin: 0.1));
    }
}
