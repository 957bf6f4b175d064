using FsCheck;
using FsCheck.Fluent;
using Harvester.Geometry.Cameras;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.Cameras;

public sealed class CameraTests
{
    private const double NearClip = 0.1;

    /// <summary>Issue's demand for the round trip, pixels.</summary>
    private const double RoundTripPixels = 1e-9;

    /// <summary>Vectors that python/tests/test_camera.py reads too; posed_projection.py computes them with 50 digits.</summary>
    private const string PosedVectors = "Cameras/posed-projection.csv";

    private const double PosedNearClip = 0.15;

    /// <summary>Coordinates are up to 4 km, whose last binary digit is 5e-13 m, and a lens multiplies it by up to 10.</summary>
    private const double UnprojectMetres = 1e-9;

    private static readonly Lens[] Lenses =
    [
        Lens.Ideal,
        new(1.02, 0.01, -0.02, -0.08, 0.01),
        new(0.97, 0, 0, 0.15, 0),
        new(1, 0, 0, -0.35, 0),
    ];

    public static TheoryData<string> ProjectionCases => [.. Vectors.Read("Cameras/projection.csv").Select(row => row["case"])];

    public static TheoryData<string> PosedCases => [.. Vectors.Read(PosedVectors).Select(row => row["case"])];

    [Theory]
    [MemberData(nameof(ProjectionCases))]
    public void Project_golden_vectors_of_a_camera_at_the_origin(string name)
    {
        IReadOnlyDictionary<string, string> row = Vectors.Read("Cameras/projection.csv").Single(r => r["case"] == name);
        var lens = new Lens(row.Number("focalScale"), row.Number("centreX"), row.Number("centreY"), row.Number("k1"), row.Number("k2"));
        var size = new ImageSize((int)row.Number("width"), (int)row.Number("height"));
        var camera = new Camera(
            new Pose(Vector3D.Zero, Axes.Identity),
            new CameraIntrinsics(row.Number("fovDegrees"), size, row.Number("windowAspect"), NearClip, lens)
        );

        Projection projection = camera.Project(new Vector3D(row.Number("x"), row.Number("y"), row.Number("z")));

        Assert.Equal(Enum.Parse<ProjectionOutcome>(row["outcome"]), projection.Outcome);
        Assert.Equal(row.Number("u"), projection.U, row.Number("tolerance"));
        Assert.Equal(row.Number("v"), projection.V, row.Number("tolerance"));
        Assert.Equal(row.Number("depth"), projection.Depth, row.Number("tolerance"));
    }

    [Theory]
    [MemberData(nameof(PosedCases))]
    public void Project_and_Unproject_posed_cameras_with_lenses(string name)
    {
        IReadOnlyDictionary<string, string> row = Vectors.Read(PosedVectors).Single(r => r["case"] == name);
        var lens = new Lens(row.Number("focalScale"), row.Number("centreX"), row.Number("centreY"), row.Number("k1"), row.Number("k2"));
        var size = new ImageSize((int)row.Number("width"), (int)row.Number("height"));
        var axes = Axes.FromVectors(row.Vector("right"), row.Vector("forward"), row.Vector("up"));
        var camera = new Camera(
            new Pose(row.Vector("position"), axes),
            new CameraIntrinsics(row.Number("fovDegrees"), size, row.Number("windowAspect"), PosedNearClip, lens)
        );

        Projection projection = camera.Project(row.Vector("point"));

        Assert.Equal(Enum.Parse<ProjectionOutcome>(row["outcome"]), projection.Outcome);
        Assert.Equal(row.Number("depth"), projection.Depth, RoundTripPixels);
        Assert.Equal(row.Number("u"), projection.U, RoundTripPixels);
        Assert.Equal(row.Number("v"), projection.V, RoundTripPixels);
        if (projection.Outcome != ProjectionOutcome.BehindNearPlane)
        {
            Vector3D point = camera.Unproject(row.Number("u"), row.Number("v"), row.Number("depth"));
            Assert.Equal(0, (point - row.Vector("point")).Length, UnprojectMetres);
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Project_of_Unproject_is_the_pixel(int lens)
    {
        RandomCases.Check(
            2_000,
            Arb.Zip(Draws.Cameras(Lenses[lens]), Sights(maxDepth: 100)),
            drawn =>
            {
                (Camera camera, (Vector2D pixel, double depth)) = drawn;

                Projection back = camera.Project(camera.Unproject(pixel.X, pixel.Y, depth));

                Assert.Equal(pixel.X, back.U, RoundTripPixels);
                Assert.Equal(pixel.Y, back.V, RoundTripPixels);
                Assert.Equal(depth, back.Depth, 1e-9);
            }
        );
    }

    [Fact]
    public void Project_moving_world_and_camera_together_changes_nothing()
    {
        RandomCases.Check(
            500,
            Arb.Zip(Draws.Cameras(Lenses[1]), Arb.Zip(Sights(maxDepth: 50), Draws.Poses(50))),
            drawn =>
            {
                (Camera camera, ((Vector2D pixel, double depth), Pose motion)) = drawn;
                Vector3D point = camera.Unproject(pixel.X, pixel.Y, depth);
                var moved = new Camera(motion.Compose(camera.Pose), camera.Intrinsics);

                Projection before = camera.Project(point);
                Projection after = moved.Project(motion.ToWorld(point));

                Assert.Equal(before.U, after.U, 1e-8);
                Assert.Equal(before.V, after.V, 1e-8);
            }
        );
    }

    [Fact]
    public void RayThrough_middle_of_the_image_looks_forward()
    {
        Camera camera = new Random(21).Camera(Lens.Ideal);

        Ray ray = camera.RayThrough(400, 300);

        Assert.Equal(1, ray.Direction.Dot(camera.Pose.Axes.Forward), 1e-12);
        Assert.Equal(camera.Pose.Position, ray.Origin);
    }

    [Fact]
    public void Camera_invalid_input_is_refused()
    {
        var size = new ImageSize(800, 600);
        Assert.Throws<ArgumentOutOfRangeException>(() => new CameraIntrinsics(0, size, 1, NearClip, Lens.Ideal));
        Assert.Throws<ArgumentOutOfRangeException>(() => new CameraIntrinsics(180, size, 1, NearClip, Lens.Ideal));
        Assert.Throws<ArgumentOutOfRangeException>(() => new CameraIntrinsics(double.NaN, size, 1, NearClip, Lens.Ideal));
        Assert.Throws<ArgumentOutOfRangeException>(() => new CameraIntrinsics(50, size, 0, NearClip, Lens.Ideal));
        Assert.Throws<ArgumentOutOfRangeException>(() => new CameraIntrinsics(50, size, 1e-320, NearClip, Lens.Ideal));
        Assert.Throws<ArgumentOutOfRangeException>(() => new CameraIntrinsics(50, size, 1, double.PositiveInfinity, Lens.Ideal));
        Assert.Throws<ArgumentOutOfRangeException>(() => new CameraIntrinsics(50, size, 1, NearClip, default));
        Assert.Throws<ArgumentOutOfRangeException>(() => new CameraIntrinsics(50, default, 1, NearClip, Lens.Ideal));
        Assert.Throws<ArgumentOutOfRangeException>(() => new ImageSize(0, 600));
        Assert.Throws<ArgumentOutOfRangeException>(() => new ImageSize(800, 65_536));
        Camera camera = new Random(22).Camera(Lens.Ideal);
        Assert.Throws<ArgumentOutOfRangeException>(() => camera.Project(new Vector3D(double.NaN, 0, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => camera.RayThrough(double.PositiveInfinity, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => camera.Unproject(0, 0, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Camera(new Pose(new(0, double.NaN, 0), Axes.Identity), camera.Intrinsics));
        Assert.Throws<ArgumentException>(() => new Camera(default, camera.Intrinsics));
        Assert.Throws<ArgumentNullException>(() => new Camera(camera.Pose, null!));
    }

    private static Arbitrary<(Vector2D Pixel, double Depth)> Sights(double maxDepth) =>
        Arb.Zip(Draws.Pixels(800, 600), RandomCases.Number(1, maxDepth));
}
