using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Tests.Boxes;

/// <summary>What is allocated for projections may not grow: a labelled frame has hundreds of them.</summary>
public class ProjectionAllocationTests
{
    private const int Times = 1000;

    /// <summary>The corners, the points of the image, the hull, and the result.</summary>
    private const long MaxBytesPerBox = 1400;

    private static readonly Camera Camera = new(
        new Pose(Vector3D.Zero, Axes.Identity), new CameraIntrinsics(90, new ImageSize(800, 600), 4.0 / 3, 0.15, Lens.Ideal));

    [Fact]
    public void Projecting_many_points_allocates_nothing()
    {
        Vector3D[] points = [.. Enumerable.Range(0, Times).Select(i => new Vector3D(i % 7, 5 + (i % 11), i % 3))];
        var projections = new Projection[Times];
        Camera.ProjectAll(points, projections);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Camera.ProjectAll(points, projections);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact]
    public void Projecting_many_points_gives_what_each_gives_alone()
    {
        Vector3D[] points = [new(1, 10, 2), new(-3, 0.1, 0), new(0, -5, 0), new(50, 4, 1)];
        var projections = new Projection[points.Length + 1];
        Camera.ProjectAll(points, projections);
        Assert.Equal([.. points.Select(Camera.Project), default], projections);
    }

    [Fact]
    public void Projecting_into_too_short_an_array_is_refused()
    {
        Assert.Throws<ArgumentException>(() => Camera.ProjectAll(new Vector3D[2], new Projection[1]));
    }

    [Fact]
    public void Projecting_a_box_allocates_little()
    {
        var cuboid = new Cuboid(new Vector3D(1, 12, 0), new Vector3D(1, 2, 0.7), Axes.FromHeading(30));
        CuboidProjector.Project(Camera, cuboid);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < Times; i++)
        {
            CuboidProjector.Project(Camera, cuboid);
        }

        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, Times * MaxBytesPerBox);
    }
}
