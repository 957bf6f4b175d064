using Harvester.Geometry.Boxes;
using Harvester.Geometry.Grids;

namespace Harvester.Geometry.Tests.Grids;

/// <summary>Grids around a vehicle and the ground on them, cell by cell against other formulas.</summary>
public sealed class GroundMapTests
{
    /// <summary>A cell whose middle is this close to an edge, metres, may be judged either way: rounding.</summary>
    private const double EdgeTolerance = 1e-6;

    private static readonly GridShape Shape = new(20, 0.5);

    /// <summary>
    /// At (100, 50), facing west: ahead is -x, right is +y. The cell of column 39 and row 0 of 40 has its middle 9.75 m ahead and 9.75 m to
    /// the right: (90.25, 59.75). The origin is in the corner of four cells.
    /// </summary>
    [Fact]
    public void Row_0_is_ahead_and_the_last_column_is_right()
    {
        var grid = new EgoGrid(new Pose(new Vector3D(100, 50, 7), Axes.FromHeading(90)), 0.5, Shape);

        Assert.Equal(40, grid.Cells);
        AssertClose(90.25, 59.75, grid.CentreOf(39, 0));
        AssertClose(20, 20, grid.PlaceOf(new Vector3D(100, 50, 3)));
        AssertClose(39.5, 0.5, grid.PlaceOf(new Vector3D(90.25, 59.75, -4)));
        Assert.Equal(6.5, grid.LevelAt(new Vector2D(80, 20)), 9);
    }

    /// <summary>Pitched up by asin(0.1), the plane rises by 0.1 / √0.99 a metre ahead: 1.005 m at 10 m. Cells stay level.</summary>
    [Fact]
    public void The_plane_rises_with_the_vehicle()
    {
        Axes axes = Axes.FromEuler(new EulerAngles(Math.Asin(0.1) * 180 / Math.PI, 0, 0));
        var grid = new EgoGrid(new Pose(new Vector3D(0, 0, 0), axes), 0, Shape);

        Assert.Equal(1.0050378, grid.LevelAt(new Vector2D(3, 10)), 6);
        AssertClose(-9.75, 9.75, grid.CentreOf(0, 0));
    }

    [Theory]
    [InlineData(5, 0.2, "The side of a grid must be 10 to 200 m, not 5 m.")]
    [InlineData(80, 0.01, "The cells of a grid must be 0.05 to 2 m, not 0.01 m.")]
    [InlineData(double.NaN, 0.2, "The side of a grid must be 10 to 200 m, not NaN m.")]
    [InlineData(80, 0.3, "A side of 80 m has 266.667 cells of 0.3 m, but it must have a whole number of them, at most 2000.")]
    [InlineData(200, 0.05, "A side of 200 m has 4000 cells of 0.05 m, but it must have a whole number of them, at most 2000.")]
    public void Other_grids_are_refused(double side, double cell, string problem)
    {
        Assert.Equal(problem, new GridShape(side, cell).Problem);
        Assert.Throws<ArgumentException>(() => new EgoGrid(new Pose(Vector3D.Zero, Axes.Identity), 0, new GridShape(side, cell)));
    }

    /// <summary>A middle is in a triangle if it is on the same side of all three edges.</summary>
    [Fact]
    public void Faces_cover_the_middles_in_them()
    {
        var random = new Random(20_261_130);
        for (int round = 0; round < 40; round++)
        {
            EgoGrid grid = GridOf(random);
            Vector3D[] corners = [.. Enumerable.Range(0, 3).Select(_ => PlaceIn(random, 14))];
            var map = new GroundMap(grid, [new GroundFace(GroundKind.Drivable, corners[0], corners[1], corners[2])]);
            for (int cell = 0; cell < map.Kinds.Count; cell++)
            {
                Vector2D middle = grid.CentreOf(cell % grid.Cells, cell / grid.Cells);
                double[] sides = [.. Enumerable.Range(0, 3).Select(i => SideOf(Flat(corners[i]), Flat(corners[(i + 1) % 3]), middle))];
                if (sides.Any(side => Math.Abs(side) < EdgeTolerance))
                {
                    continue;
                }

                bool isIn = sides.All(side => side > 0) || sides.All(side => side < 0);
                Assert.Equal(isIn ? GroundKind.Drivable : GroundKind.Other, map.Kinds[cell]);
                Assert.Equal(isIn, !double.IsNaN(map.Heights[cell]));
                if (isIn)
                {
                    // The point of the plane above the middle: n · (p - a) = 0.
                    Vector3D normal = (corners[1] - corners[0]).Cross(corners[2] - corners[0]);
                    var point = new Vector3D(middle.X, middle.Y, map.Heights[cell]);
                    Assert.Equal(0, normal.Normalized().Dot(point - corners[0]), 6);
                }
            }
        }
    }

    /// <summary>A body covers a cell if the middle is in the outline of its corners: on no outer side of any two of them.</summary>
    [Fact]
    public void Bodies_cover_the_outline_of_their_corners()
    {
        var random = new Random(20_261_131);
        int compared = 0;
        for (int round = 0; round < 40; round++)
        {
            EgoGrid grid = GridOf(random);
            var map = new GroundMap(grid, []);
            var axes = Axes.FromEuler(
                new EulerAngles((random.NextDouble() * 40) - 20, (random.NextDouble() * 40) - 20, random.NextDouble() * 360)
            );
            Vector3D centre = PlaceIn(random, 12);
            Vector2D at = Flat(centre);
            var body = new Cuboid(
                new Vector3D(centre.X, centre.Y, grid.LevelAt(at) + 0.8),
                new Vector3D(0.3 + random.NextDouble(), 0.3 + (3 * random.NextDouble()), 0.8),
                axes
            );
            var covered = map.CellsUnder(body).ToHashSet();
            Vector2D[] corners = [.. Enumerable.Range(0, 8).Select(number => Flat(body.Corner(number)))];
            for (int cell = 0; cell < map.Kinds.Count; cell++)
            {
                double within = WithinHull(corners, grid.CentreOf(cell % grid.Cells, cell / grid.Cells));
                if (Math.Abs(within) > EdgeTolerance)
                {
                    Assert.Equal(within > 0, covered.Contains(cell));
                    compared += within > 0 ? 1 : 0;
                }
            }
        }

        Assert.True(compared > 200, $"Only {compared} cells were covered.");
    }

    /// <summary>
    /// A bridge 6 m above a road, both flat. On the road the road counts, on the bridge the bridge; a kerb 0.15 m above the road hides it;
    /// a lane counts on a road only, and on the bridge not the lane below. A body on the bridge is not on the road.
    /// </summary>
    [Theory]
    [InlineData(0)]
    [InlineData(6)]
    public void The_level_of_the_vehicle_counts(double level)
    {
        GroundFace[] faces =
        [
            .. Square(GroundKind.Drivable, -8, 8, 0),
            .. Square(GroundKind.Drivable, -4, 4, 6),
            .. Square(GroundKind.Other, 5, 8, 0.15),
            .. Square(GroundKind.Lane, -8, 8, 0),
            .. Square(GroundKind.Line, -1, 1, 6.002),
        ];
        var grid = new EgoGrid(new Pose(new Vector3D(0, 0, level), Axes.Identity), 0, Shape);
        var map = new GroundMap(grid, faces);
        var reversed = new GroundMap(grid, [.. faces.Reverse()]);
        var onBridge = new Cuboid(new Vector3D(0.25, 0.25, 6.7), new Vector3D(0.2, 0.2, 0.7), Axes.Identity);
        int middle = (19 * 40) + 20;

        Assert.Equal(map.Kinds, reversed.Kinds);
        Assert.Equal(level == 0 ? GroundKind.Lane : GroundKind.Line, map.Kinds[middle]);
        Assert.Equal(level == 0 ? 0 : 6.002, map.Heights[middle], 9);
        Assert.Equal(GroundKind.Lane, map.Kinds[(4 * 40) + 20]);
        Assert.Equal(GroundKind.Other, map.Kinds[(7 * 40) + 32]);
        Assert.Equal(GroundKind.Other, map.Kinds[0]);
        Assert.Equal(level == 0 ? [] : [middle], map.CellsUnder(onBridge));
    }

    /// <summary>A plane that rises by 0.1 to the east and falls by 0.2 to the north, and a kerb of 0.15 m on it at x = 1.</summary>
    [Fact]
    public void Slopes_are_those_of_the_ground_and_kerbs_are_none()
    {
        static Vector3D On(double x, double y, double lift) => new(x, y, (0.1 * x) - (0.2 * y) + lift);
        GroundFace[] faces =
        [
            new(GroundKind.Drivable, On(-20, -20, 0), On(40, -20, 0), On(-20, 40, 0)),
            new(GroundKind.Other, On(1, -20, 0.15), On(40, -20, 0.15), On(1, 40, 0.15)),
        ];
        var grid = new EgoGrid(new Pose(Vector3D.Zero, Axes.FromHeading(30)), 0, Shape);
        var map = new GroundMap(grid, faces);
        Vector3D expected = new Vector3D(-0.1, 0.2, 1).Normalized();

        // Near the diagonal of the large triangle and at the border there are no neighbours.
        for (int cell = 12 * 40; cell < 28 * 40; cell++)
        {
            if (cell % 40 is > 12 and < 28)
            {
                Assert.InRange((map.NormalAt(cell) - expected).Length, 0, 1e-9);
            }
        }
    }

    private static IEnumerable<GroundFace> Square(GroundKind kind, double from, double to, double height)
    {
        Vector3D[] corners = [new(from, from, height), new(to, from, height), new(to, to, height), new(from, to, height)];
        return [new(kind, corners[0], corners[1], corners[2]), new(kind, corners[0], corners[2], corners[3])];
    }

    private static EgoGrid GridOf(Random random) =>
        new(new Pose(PlaceIn(random, 3), Axes.FromHeading(random.NextDouble() * 360)), random.NextDouble(), Shape);

    private static Vector3D PlaceIn(Random random, double half) => new(Between(random, half), Between(random, half), Between(random, 0.3));

    private static double Between(Random random, double half) => ((2 * random.NextDouble()) - 1) * half;

    private static Vector2D Flat(Vector3D point) => new(point.X, point.Y);

    private static double SideOf(Vector2D from, Vector2D to, Vector2D point) => (to - from).Cross(point - from) / (to - from).Length;

    /// <summary>How far a point is inside the outline of others; negative outside.</summary>
    private static double WithinHull(Vector2D[] corners, Vector2D point)
    {
        double within = double.PositiveInfinity;
        foreach (Vector2D from in corners)
        {
            foreach (Vector2D to in corners)
            {
                // An edge of the outline has all corners on its left.
                if ((to - from).Length > EdgeTolerance && corners.All(other => SideOf(from, to, other) > -EdgeTolerance))
                {
                    within = Math.Min(within, SideOf(from, to, point));
                }
            }
        }

        return within;
    }

    private static void AssertClose(double x, double y, Vector2D actual)
    {
        Assert.Equal(x, actual.X, 9);
        Assert.Equal(y, actual.Y, 9);
    }
}
