using Harvester.Geometry.Boxes;
using Harvester.Geometry.Grids;

namespace Harvester.Geometry.Tests.Grids;

/// <summary>
/// Voxels of boxes compared with the separating-axis test of two boxes, which decides for each voxel whether a box reaches into it.
/// </summary>
public class VoxelMapTests
{
    /// <summary>A voxel whose distance from a box is within this, metres, may be judged either way: rounding.</summary>
    private const double Touching = 1e-9;

    private const byte Kind = 1;
    private const int Owner = 7;
    private static readonly VoxelShape Shape = new(40, 16, 0.5, -2);

    [Theory]
    [InlineData(1, 3)]
    public void Voxels_of_boxes_are_those_that_their_sides_meet(int seed, int boxes)
    {
        var random = new Random(seed);
        (int compared, int occupied, int enclosed) = (0, 0, 0);
        for (int number = 0; number < boxes; number++)
        {
            var grid = new VoxelGrid(new Pose(new Vector3D(Any(50), Any(50), Any(5)), Turn()), Shape);

            // In a corner of the grid, away from the vehicle in its middle.
            Vector3D centre = grid.PointAt(6 + Between(0, 6), 6 + Between(0, 6), 4 + Between(0, 8));
            var box = new Cuboid(centre, new Vector3D(Between(0.1, 1.8), Between(0.1, 1.8), Between(0.1, 1.8)), Turn());
            VoxelMap map = MapOf(grid, box);
            for (int voxel = 0; voxel < Shape.Count; voxel++)
            {
                double gap = GapBetween(grid, voxel, box);
                double depth = DepthInside(grid, voxel, box);
                if (Math.Abs(gap) < Touching || Math.Abs(depth) < Touching)
                {
                    continue;
                }

                byte expected =
                    gap > 0 ? VoxelMap.Free
                    : depth > 0 ? VoxelMap.Enclosed
                    : Kind;
                compared++;
                occupied += expected == Kind ? 1 : 0;
                enclosed += expected == VoxelMap.Enclosed ? 1 : 0;
                Assert.True(expected == map.Kinds[voxel], $"Box {number}, voxel {voxel}: {map.Kinds[voxel]} instead of {expected}.");
                Assert.Equal(expected == Kind ? Owner : 0, map.Owners[voxel]);
            }
        }

        Assert.True(compared > boxes * Shape.Count * 0.99 && occupied > 20 * boxes && enclosed > 0, "Too few voxels were compared.");

        double Between(double from, double to) => from + ((to - from) * random.NextDouble());

        double Any(double reach) => Between(-reach, reach);

        Axes Turn() => Axes.FromEuler(new EulerAngles(Any(80), Any(180), Any(180)));
    }

    [Fact]
    public void Of_kinds_in_a_voxel_the_greatest_rank_counts()
    {
        var grid = new VoxelGrid(new Pose(Vector3D.Zero, Axes.Identity), Shape);
        var map = new VoxelMap(grid, [0, 2, 1]);
        map.Add(1, 9, new(3.2, 3.2, 3.5), new(3.8, 3.2, 3.5), new(3.2, 3.8, 3.5));
        map.Add(2, 5, new(3.2, 3.2, 3.6), new(3.8, 3.2, 3.6), new(3.2, 3.8, 3.6));
        map.Add(1, 8, new(3.2, 3.2, 3.7), new(3.8, 3.2, 3.7), new(3.2, 3.8, 3.7));

        int voxel = (((3 * Shape.Cells) + 3) * Shape.Cells) + 3;
        Assert.Equal(((byte)1, 8), (map.Kinds[voxel], map.Owners[voxel]));
        Assert.Equal(1, map.Kinds.Count(kind => kind != VoxelMap.Free));
    }

    private static VoxelMap MapOf(VoxelGrid grid, Cuboid box)
    {
        // Each side of the box, by a corner and its two edges: two triangles.
        var map = new VoxelMap(grid, [0, 1]);
        Vector3D[] axes = [box.Axes.Right * box.HalfExtents.X, box.Axes.Forward * box.HalfExtents.Y, box.Axes.Up * box.HalfExtents.Z];
        for (int axis = 0; axis < 3; axis++)
        {
            (Vector3D first, Vector3D second) = (axes[(axis + 1) % 3], axes[(axis + 2) % 3]);
            foreach (int side in new[] { -1, 1 })
            {
                Vector3D middle = box.Centre + (axes[axis] * side);
                Vector3D[] corners =
                [
                    .. new[] { middle - first - second, middle + first - second, middle + first + second, middle - first + second }.Select(
                        grid.PlaceOf
                    ),
                ];
                map.Add(Kind, Owner, corners[0], corners[1], corners[2]);
                map.Add(Kind, Owner, corners[0], corners[2], corners[3]);
            }
        }

        map.Close();
        return map;
    }

    /// <summary>The greatest gap between a voxel and a box along the 15 axes that can separate them; negative if they overlap.</summary>
    private static double GapBetween(VoxelGrid grid, int voxel, Cuboid box)
    {
        double half = Shape.CellMetres / 2;
        Vector3D[] own = [grid.Frame.Axes.Right, grid.Frame.Axes.Forward, grid.Frame.Axes.Up];
        Vector3D[] others = [box.Axes.Right, box.Axes.Forward, box.Axes.Up];
        double[] extents = [box.HalfExtents.X, box.HalfExtents.Y, box.HalfExtents.Z];
        Vector3D between = box.Centre - grid.CentreOf(voxel);
        IEnumerable<Vector3D> axes = own.Concat(others)
            .Concat(own.SelectMany(first => others.Select(first.Cross)))
            .Where(static axis => axis.Length > 1e-6)
            .Select(static axis => axis.Normalized());
        return axes.Max(axis =>
            Math.Abs(axis.Dot(between))
            - own.Sum(each => half * Math.Abs(axis.Dot(each)))
            - others.Select((each, at) => extents[at] * Math.Abs(axis.Dot(each))).Sum()
        );
    }

    /// <summary>How far the corners of a voxel lie inside the sides of a box, metres; negative if one lies outside.</summary>
    private static double DepthInside(VoxelGrid grid, int voxel, Cuboid box)
    {
        double half = Shape.CellMetres / 2;
        Vector3D[] own = [grid.Frame.Axes.Right, grid.Frame.Axes.Forward, grid.Frame.Axes.Up];
        Vector3D between = grid.CentreOf(voxel) - box.Centre;
        (Vector3D Axis, double Extent)[] sides =
        [
            (box.Axes.Right, box.HalfExtents.X),
            (box.Axes.Forward, box.HalfExtents.Y),
            (box.Axes.Up, box.HalfExtents.Z),
        ];
        return sides.Min(side => side.Extent - Math.Abs(side.Axis.Dot(between)) - own.Sum(each => half * Math.Abs(side.Axis.Dot(each))));
    }
}
