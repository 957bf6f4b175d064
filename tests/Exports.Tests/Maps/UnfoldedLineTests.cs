using Harvester.Exports.Maps;
using Harvester.Geometry;

namespace Harvester.Exports.Tests.Maps;

public sealed class UnfoldedLineTests
{
    private const double HalfWidth = 2.7;

    /// <summary>The edge has a point each 0.1 m, so that its corner is as near to that of the exact edges.</summary>
    private const double Step = 0.1;

    [Fact]
    public void Edge_inside_a_corner_has_a_corner()
    {
        (Vector3D[] middle, Vector3D[] edge) = Bend(radius: 0.05);

        IReadOnlyList<Vector3D> unfolded = UnfoldedLine.Of(edge, middle);

        // The edges beside both straights, y = w and x = -w, meet there.
        var corner = new Vector3D(-HalfWidth, HalfWidth, 0);
        Assert.True(unfolded.Min(point => (point - corner).Length) < Step);
        Assert.Equal(edge[0], unfolded[0]);
        Assert.Equal(edge[^1], unfolded[^1]);
        Assert.All(unfolded, point => Assert.True(point.X <= -HalfWidth + Step && point.Y >= 0 || point.Y <= HalfWidth + Step));
    }

    [Theory]
    [InlineData(0.05)]
    [InlineData(0.5)]
    [InlineData(1.5)]
    [InlineData(2.6)]
    public void Edge_inside_a_bend_never_runs_back(double radius)
    {
        (Vector3D[] middle, Vector3D[] edge) = Bend(radius);
        Assert.True(UnfoldedLine.IsFolded(edge, middle));

        IReadOnlyList<Vector3D> unfolded = UnfoldedLine.Of(edge, middle);

        // In a bend from east to north, both coordinates grow along the edge, except within one step of its corner.
        Assert.All(
            unfolded.Zip(unfolded.Skip(1)),
            step => Assert.True(step.Second.X > step.First.X - (1.01 * Step) && step.Second.Y > step.First.Y - (1.01 * Step))
        );
    }

    [Fact]
    public void Edge_with_room_stays()
    {
        (Vector3D[] middle, Vector3D[] edge) = Bend(radius: 3);

        Assert.False(UnfoldedLine.IsFolded(edge, middle));
        Assert.Equal(edge, UnfoldedLine.Of(edge, middle));
    }

    [Fact]
    public void Edge_that_runs_back_from_end_to_end_is_its_ends()
    {
        Vector3D[] middle = [new(0, 0, 0), new(1, 0, 0), new(2, 0, 0)];
        Vector3D[] edge = [new(2, 1, 0), new(1, 1, 0), new(0, 1, 0)];

        Assert.Equal([edge[0], edge[^1]], UnfoldedLine.Of(edge, middle));
    }

    /// <summary>A lane that comes from the west and turns north around (-r, r), and its left edge.</summary>
    private static (Vector3D[] Middle, Vector3D[] Edge) Bend(double radius)
    {
        List<Vector3D> middle = [],
            edge = [];
        const int steps = 100;
        for (int i = steps; i > 0; i--)
        {
            Add(new(-radius - (i * Step), 0, 0), new(0, 1, 0));
        }

        for (int i = 0; i <= steps; i++)
        {
            double angle = Math.PI / 2 * i / steps;
            var aside = new Vector3D(-Math.Sin(angle), Math.Cos(angle), 0);
            Add(new Vector3D(-radius, radius, 0) - (aside * radius), aside);
        }

        for (int i = 1; i <= steps; i++)
        {
            Add(new(0, radius + (i * Step), 0), new(-1, 0, 0));
        }

        return ([.. middle], [.. edge]);

        void Add(Vector3D place, Vector3D left)
        {
            middle.Add(place);
            edge.Add(place + (left * HalfWidth));
        }
    }
}
