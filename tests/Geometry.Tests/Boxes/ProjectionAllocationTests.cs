using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Tests.Boxes;

/// <summary>What is allocated for projections may not grow: a labelled frame has hundreds of them.</summary>
public class ProjectionAllocationTests
{
    private const int Times = 1000;

    /// <summary>The result and its silhouette of at most six corners.</summary>
    private const long MaxBytesPerBox = 300;

    private static readonly Camera Camera = new(
        new Pose(Vector3D.Zero, Axes.Identity),
        new CameraIntrinsics(90, new ImageSize(800, 600), 4.0 / 3, 0.15, Lens.Ideal)
    );

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
    public void Projecting_by_fours_gives_the_bits_of_each_alone()
    {
        var random = new Random(1);
        var pose = new Pose(new Vector3D(3, -2, 1), Axes.FromEuler(new EulerAngles(3, -2, 75)));
        var camera = new Camera(pose, new CameraIntrinsics(60, new ImageSize(800, 600), 1.4, 0.15, new Lens(1.01, 0.01, -0.02, 0, 0)));
        Vector3D[] points =
        [
            .. Enumerable
                .Range(0, 4001)
                .Select(_ => pose.ToWorld(new Vector3D(random.Between(-30, 30), random.Between(-10, 40), random.Between(-20, 20)))),
        ];
        var projections = new Projection[points.Length];

        camera.ProjectAll(points, projections);

        Assert.Equal([.. points.Select(camera.Project)], projections);
        Assert.All(Enum.GetValues<ProjectionOutcome>(), outcome => Assert.Contains(projections, found => found.Outcome == outcome));
    }

    [Theory]
    [InlineData(2, double.NaN)]
    [InlineData(6, double.PositiveInfinity)]
    [InlineData(8, double.NegativeInfinity)]
    public void Projecting_many_points_refuses_one_that_is_not_finite(int place, double coordinate)
    {
        Vector3D[] points = [.. Enumerable.Repeat(new Vector3D(1, 10, 2), 9)];
        points[place] = new Vector3D(0, 10, coordinate);

        Assert.Throws<ArgumentOutOfRangeException>(() => Camera.ProjectAll(points, new Projection[points.Length]));
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

    [Theory]
    [InlineData(12, 0)]
    [InlineData(12, -0.2)]
    [InlineData(1, 0)]
    [InlineData(0, -0.2)]
    [InlineData(-20, 0)]
    public void Boxes_without_a_silhouette_allocate_nothing(double ahead, double k1)
    {
        var cuboid = new Cuboid(new Vector3D(1, ahead, 0), new Vector3D(1, 2, 0.7), Axes.FromHeading(30));
        Camera camera = new(Camera.Pose, new CameraIntrinsics(90, new ImageSize(800, 600), 4.0 / 3, 0.15, new Lens(1, 0, 0, k1, 0)));
        CuboidProjector.BoxesOf(camera, cuboid);
        long before = GC.GetAllocatedBytesForCurrentThread();
        BoxProjection boxes = CuboidProjector.BoxesOf(camera, cuboid);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);

        CuboidProjection whole = CuboidProjector.Project(camera, cuboid);
        Assert.Equal(new BoxProjection(whole.Outcome, whole.Box, whole.AmodalBox, whole.TruncatedFraction), boxes);
    }
}
