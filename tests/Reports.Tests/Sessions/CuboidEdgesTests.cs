using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Reports.Sessions;

namespace Harvester.Reports.Tests.Sessions;

public sealed class CuboidEdgesTests
{
    // f = 300: fov 90, 800 x 600.
    private static readonly Camera Camera = new(
        new Pose(Vector3D.Zero, Axes.Identity),
        new CameraIntrinsics(90, new ImageSize(800, 600), 4.0 / 3, 0.15, Lens.Ideal)
    );

    [Fact]
    public void Edges_of_a_cuboid_ahead_match_hand_computed_ends()
    {
        (Vector2D Start, Vector2D End)[] edges = [.. CuboidEdges.Of(Camera, new Cuboid(new(0, 20, 0), new(1, 10, 1), Axes.Identity))];

        // The near face at 10 m: 400 ± 30, 300 ± 30; the far one at 30 m: 400 ± 10, 300 ± 10.
        Assert.Equal(12, edges.Length);
        Vector2D[] ends = [.. edges.SelectMany(edge => new[] { edge.Start, edge.End }).Distinct()];
        Assert.Equal(8, ends.Length);
        Assert.All(ends, end => Assert.Contains(Math.Round(Math.Abs(end.X - 400), 6), new[] { 10.0, 30 }));
    }

    [Fact]
    public void Edges_of_a_cuboid_are_clipped_at_the_near_plane()
    {
        (Vector2D Start, Vector2D End)[] edges = [.. CuboidEdges.Of(Camera, new Cuboid(new(0, 0, 0), new(1, 10, 1), Axes.Identity))];

        // The four edges of the rear face are gone; the four along the view are cut at 0.15 m: 300 * 1 / 0.15 = 2000 from the middle.
        Assert.Equal(8, edges.Length);
        const int digits = 3;
        Assert.Equal(2000, edges.Max(edge => Math.Max(Math.Abs(edge.Start.X - 400), Math.Abs(edge.End.X - 400))), digits);
    }

    [Fact]
    public void Cuboid_behind_the_camera_has_no_edges() =>
        Assert.Empty(CuboidEdges.Of(Camera, new Cuboid(new(0, -20, 0), new(1, 10, 1), Axes.Identity)));
}
